// tests/network/match.hpp: where everything is at any moment; what the robots of the test bench
// play.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/identity.hpp"
#include "geometry/pose.hpp"
#include "geometry/time.hpp"

namespace teamsight::network {

inline constexpr RobotId kRobots = 6;

/// Moment of the match: the monotonic clock of the test itself, not of any host.
using MatchTime = Duration;

[[nodiscard]] Point<Field> ball_at(MatchTime time);
[[nodiscard]] Pose<Field, Robot> robot_at(RobotId robot, MatchTime time);

/// The five opponents.
[[nodiscard]] std::vector<Point<Field>> opponents_at(MatchTime time);

}  // namespace teamsight::network
