// vision/obstacle_model.cpp: the logistic function, and the weights.
#include "vision/obstacle_model.hpp"

#include <cmath>

namespace teamsight::vision {

double probability(const ObstacleModel& model, const ObstacleTraits& traits) {
  double log_odds = model.bias;
  for (std::size_t i = 0; i < kTraits; ++i) log_odds += model.weights[i] * traits[i];
  return 1.0 / (1.0 + std::exp(-log_odds));
}

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
