// fusion/kick_habits.hpp: how often the balls of this game are kicked into the air.
#pragma once

#include "fusion/ball_motion.hpp"

namespace teamsight::fusion {

/// Kicks that were seen, by kind; those of long ago count less.
struct KickTally {
  double along{0.0};  ///< along the floor
  double high{0.0};   ///< into the air
};

/// Takes one more in. Of the last `BallMotion::kick_memory` kicks each counts about as much.
void count_kick(KickTally& tally, BallMode into, const BallMotion& motion);

/// Share of this game's kicks that go into the air, in (0, 1): what is known of all games weighs as
/// much as `BallMotion::high_share_weight` kicks of this one (mean of a beta distribution).
[[nodiscard]] double high_share(const KickTally& tally, const BallMotion& motion);

}  // namespace teamsight::fusion
