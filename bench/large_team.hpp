// bench/large_team.hpp: instead of geometry/identity.hpp's robots, for bench-fusion-large alone.
//
// The topics name 16 robots, and so does every program that speaks on them. To show how fusion
// grows beyond that, its sources are compiled once more with room for 64.
#pragma once

#include <cstdint>

#define TEAMSIGHT_LARGE_TEAM

namespace teamsight {

using RobotId = std::uint8_t;
inline constexpr RobotId kNobody = 0;
inline constexpr RobotId kMaxRobotId = 64;

using RobotMask = std::uint64_t;

[[nodiscard]] constexpr RobotMask robot_bit(RobotId robot) {
  return robot == kNobody || robot > kMaxRobotId ? RobotMask{0} : RobotMask{1} << (robot - 1U);
}

}  // namespace teamsight
