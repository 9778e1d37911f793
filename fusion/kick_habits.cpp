// fusion/kick_habits.cpp: see fusion/kick_habits.hpp.
#include "fusion/kick_habits.hpp"

namespace teamsight::fusion {

void count_kick(KickTally& tally, BallMode into, const BallMotion& motion) {
  const double keep = 1.0 - 1.0 / motion.kick_memory;
  tally.along *= keep;
  tally.high *= keep;
  (into == BallMode::kFlying ? tally.high : tally.along) += 1.0;
}

double high_share(const KickTally& tally, const BallMotion& motion) {
  const double weight = motion.high_share_weight;
  return (weight * motion.high_share + tally.high) / (weight + tally.along + tally.high);
}

}  // namespace teamsight::fusion
