// examples/behaviour/attacker.hpp: who goes to the ball, the same answer in every robot.
#pragma once

#include <optional>

#include "geometry/world_model.hpp"

namespace behaviour {

/// The robot that goes to the ball, and how long it needs.
struct Attacker {
  teamsight::RobotId robot{teamsight::kNobody};
  double time_to_ball{0.0};  ///< s
};

/// Chooses the trusted teammate that is first at the most probable ball: turning towards it on the
/// spot, then driving straight at full speed.
///
/// Robots that read the same world model choose the same: equally quick ones are told apart by id.
///
/// @return nothing if there is no ball or nobody that can be trusted
[[nodiscard]] std::optional<Attacker> choose_attacker(const teamsight::WorldModel& world);

}  // namespace behaviour
