// geometry/identity.hpp: who speaks, and which of his words this is.
#pragma once

#include <compare>
#include <cstdint>

namespace teamsight {
#ifndef TEAMSIGHT_LARGE_TEAM  // else bench/large_team.hpp, with room for more robots
/// A robot of the own team, 1 to 16; 0 is nobody.
using RobotId = std::uint8_t;
inline constexpr RobotId kNobody = 0;
inline constexpr RobotId kMaxRobotId = 16;

/// A set of robots: bit i stands for robot i + 1.
using RobotMask = std::uint16_t;

/// The bit of one robot in a RobotMask; nobody has none.
[[nodiscard]] constexpr RobotMask robot_bit(RobotId robot) {
  return robot == kNobody || robot > kMaxRobotId
             ? RobotMask{0}
             : static_cast<RobotMask>(1U << static_cast<unsigned>(robot - 1));
}
#endif
/// Names one frame of one robot, for good: the same frame received twice has the same id.
struct ObservationId {
  RobotId robot{kNobody};
  std::uint32_t boot{0};      ///< drawn at random when the process starts; never 0 in a valid id
  std::uint32_t sequence{0};  ///< counts frames since then, from 1
  // clang-tidy 14 takes the zero within <=> for a pointer.
  friend auto operator<=>(const ObservationId&, const ObservationId&) = default;  // NOLINT
};

}  // namespace teamsight
