// fusion/elsewhere.hpp: whether one other posture explains all that a robot sees.
#pragma once

#include <Eigen/Core>

#include "fusion/parameters.hpp"
#include "fusion/witness.hpp"

namespace teamsight::fusion {

/// Log-odds that the robot stands in one other posture, anywhere on the field, rather than where it
/// says: by how the obstacles that its frame shows fit what at least two others say is there. Pairs
/// of what it sees are laid upon pairs of claims as far apart. Postures near the one it says, or
/// near that one's mirror image, are left out: they have names of their own.
///
/// @param centre_F  about which the field is symmetric
/// @return 0 where nothing speaks for another posture
[[nodiscard]] double log_odds_elsewhere(const Testimony& testimony,
                                        const ClaimList& claims,
                                        const Eigen::Vector2d& centre_F,
                                        const TrustParameters& parameters);

}  // namespace teamsight::fusion
