// vision/ball_model.hpp: how probably a blob with given traits is a ball.
#pragma once

#include "vision/ball_traits.hpp"
#include "vision/trait_model.hpp"

namespace teamsight::vision {

using BallModel = TraitModel<kBallTraits>;

/// What `teamsight calibrate balls` made of the labelled images; see vision/README.md for how well
/// it does on images it was not made from.
[[nodiscard]] BallModel trained_ball_model();

}  // namespace teamsight::vision
