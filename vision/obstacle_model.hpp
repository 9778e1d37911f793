// vision/obstacle_model.hpp: how probably something with given traits is a robot.
#pragma once

#include "vision/obstacle_traits.hpp"
#include "vision/trait_model.hpp"

namespace teamsight::vision {

using ObstacleModel = TraitModel<kTraits>;

/// What `teamsight calibrate robots` made of the labelled images; see vision/README.md for how well
/// it does on images it was not made from.
[[nodiscard]] ObstacleModel trained_obstacle_model();

}  // namespace teamsight::vision
