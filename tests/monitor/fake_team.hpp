// tests/monitor/fake_team.hpp: a team that never was, moving on smooth paths; what it would send.
#pragma once

#include <cstdint>

#include "bus/messages.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::test {

inline constexpr std::uint8_t kFakeRobots = 5;

/// What robot `robot` (1 to kFakeRobots) says of a frame exposed at `exposure`, published 25 ms
/// later.
[[nodiscard]] bus::RobotState fake_state(const ObservationId& id, HostTime exposure);
[[nodiscard]] bus::Sightings fake_sightings(const ObservationId& id, HostTime exposure);

[[nodiscard]] bus::VirtualSensors fake_sensors(const ObservationId& id, HostTime exposure);

/// What a fusion that hears all of them makes of it. Robot 4's ball does not fit the others'.
[[nodiscard]] WorldModel fake_world(const ObservationId& id, HostTime stamp);
[[nodiscard]] bus::Explanation fake_explanation(const ObservationId& id, HostTime stamp);

/// What the simulator of that match knows.
[[nodiscard]] bus::Truth fake_truth(const ObservationId& id, HostTime stamp);

}  // namespace teamsight::test
