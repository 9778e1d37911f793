// bench/fuse_score/shared_evidence.hpp: for how long a robot's fault could be known to its team.
#pragma once

#include "bench/play/play_log.hpp"

namespace teamsight::score {

/// For how long, since the fault began, the team had something to compare: the time within 0.3 s
/// after the arrival of a frame of the bad robot or of another, where the two were exposed within
/// 0.3 s of each other and show the same ball or player, or one of them the other's robot.
///
/// @param until  s since the start
/// @return s
[[nodiscard]] double shared_evidence_until(const play::PlayLog& log,
                                           const play::FaultPlan& fault,
                                           double until);

}  // namespace teamsight::score
