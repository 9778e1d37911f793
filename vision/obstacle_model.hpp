// vision/obstacle_model.hpp: how probably something with given traits stands on the carpet.
#pragma once

#include "vision/obstacle_traits.hpp"

namespace teamsight::vision {

/// Log-odds as a weighted sum of the traits.
struct ObstacleModel {
  ObstacleTraits weights{};
  double bias{0.0};
  double least{0.5};  ///< probability from which it is reported

  friend bool operator==(const ObstacleModel&, const ObstacleModel&) = default;
};

/// That it is a robot or a person on the carpet, in [0, 1].
[[nodiscard]] double probability(const ObstacleModel& model, const ObstacleTraits& traits);

/// What `teamsight train obstacles` made of the labelled images; see vision/README.md for how well
/// it does on images it was not made from.
[[nodiscard]] ObstacleModel trained_obstacle_model();

}  // namespace teamsight::vision
