// process/identity_guard.hpp: two processes must not speak under one robot's id.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "bus/computer.hpp"
#include "bus/messages.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"

namespace teamsight::process {

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

/// The line for whoever has to mend it: who the other one is, and what to do. Fits a report.
[[nodiscard]] std::string words_on_rival(RobotId robot, const bus::Computer& of_the_other);

/// A reader that was only just discovered may miss one: so often it is said, and so far apart.
inline constexpr int kLastReports = 3;
inline constexpr Duration kBetweenLastReports = std::chrono::milliseconds(300);

/// What such a process says before it ends, for the coach; as a process of its own name, so that
/// it does not take turns with the other one's reports.
///
/// @param process  what it would have been called, e.g. "agent/3"
[[nodiscard]] bus::Diagnostics last_report(const std::string& process,
                                           RobotId robot,
                                           const std::string& words,
                                           HostTime now);

}  // namespace teamsight::process
