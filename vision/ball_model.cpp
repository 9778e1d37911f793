// vision/ball_model.cpp: the weights.
#include "vision/ball_model.hpp"

namespace teamsight::vision {

BallModel trained_ball_model() {
  BallModel model;
  model.weights = {
      -1.503,  // too_small
      -1.777,  // too_large
      7.599,   // roundness
      5.653,   // ground
      0.780,   // inside_carpet
      2.445,   // contrast
  };
  model.bias = -17.958;
  model.least = 0.4;
  return model;
}

}  // namespace teamsight::vision
