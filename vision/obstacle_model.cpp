// vision/obstacle_model.cpp: the weights.
#include "vision/obstacle_model.hpp"

namespace teamsight::vision {

ObstacleModel trained_obstacle_model() {
  ObstacleModel model;
  model.weights = {
      -2.663,  // odd_width
      1.321,   // carpet_beside
      2.262,   // inside_hull
      14.642,  // shirt_high
      0.903,   // standing_high
      1.513,   // floor_high
      5.032,   // closed
      1.814,   // carpet_at_flanks
      -2.460,  // rough_foot
  };
  model.bias = -13.152;
  model.least = 0.4;
  return model;
}

}  // namespace teamsight::vision
