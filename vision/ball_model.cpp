// vision/ball_model.cpp: the weights.
#include "vision/ball_model.hpp"

namespace teamsight::vision {

BallModel trained_ball_model() {
  BallModel model;
  model.weights = {
      -1.400,  // too_small
      -2.072,  // too_large
      7.436,   // roundness
      5.623,   // ground
      0.774,   // inside_carpet
      2.315,   // contrast
  };
  model.bias = -17.364;
  model.least = 0.4;
  return model;
}

}  // namespace teamsight::vision
