// fusion/fusion.hpp: the whole fusion as one value: observations in, world out, time as an argument.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "fusion/observation.hpp"
#include "fusion/parameters.hpp"
#include "geometry/field_model.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::fusion {

/// What became of one observation.
enum class Intake : std::uint8_t { kAccepted, kDuplicate, kTooOld, kFromTheFuture };

// The class `Fusion` is designed by this folder; its public face:
//   Intake insert(const Observation&, HostTime now);   any order, duplicates welcome
//   WorldModel world_at(HostTime now) const;           the same observations give the same world
// Everything else (RobotState's flags, clocks, leadership) comes in as plain arguments.

}  // namespace teamsight::fusion
