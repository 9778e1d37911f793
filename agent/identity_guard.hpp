// agent/identity_guard.hpp: two processes must not speak under one robot's id.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/identity.hpp"

namespace teamsight::agent {

/// What to do about a sample that carries our robot id and another boot id.
enum class Rivalry : std::uint8_t { kNone, kStay, kYield };

/// Decides between this process and another one with the same robot id: the newcomer yields.
///
/// The younger one is the one that has written fewer samples; if their counts are within a factor
/// of two they started together, and the larger boot id yields. Both sides come to the same answer.
///
/// @param own    robot, boot and how many samples this process has written
/// @param heard  of a sample that was received
[[nodiscard]] Rivalry judge_rival(const ObservationId& own, const ObservationId& heard);

}  // namespace teamsight::agent
