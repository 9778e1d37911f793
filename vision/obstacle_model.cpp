// vision/obstacle_model.cpp: the weights.
#include "vision/obstacle_model.hpp"

namespace teamsight::vision {

ObstacleModel trained_obstacle_model() {
  ObstacleModel model;
  model.weights = {
      -3.539,  // odd_width
      1.388,   // carpet_beside
      1.713,   // inside_hull
      11.226,  // shirt_high
      2.607,   // standing_high
      4.321,   // floor_high
      6.019,   // closed
      2.254,   // carpet_at_flanks
      -1.834,  // rough_foot
  };
  model.bias = -15.074;
  model.least = 0.4;
  return model;
}

}  // namespace teamsight::vision
