// monitor/replay.hpp: a recording as the page gets it: all updates of the station, made again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "geometry/time.hpp"
#include "monitor/station.hpp"

namespace teamsight::monitor {

/// A whole recording for the page.
struct Replay {
  std::string body;  ///< MonitorUpdates, each behind its length (4 bytes, little-endian)
  std::string team;  ///< as the recording says; empty if it does not
  Duration date_minus_stamp{0};  ///< makes a date of the updates' stamps
  std::uint64_t updates{0};
  std::uint64_t skipped{0};  ///< messages that no reader on the bus would have taken
  std::string damage;        ///< why the recording's end is missing; empty: it is whole
};

/// Every so much time of the recording there is an update.
inline constexpr Duration kReplayStep = std::chrono::milliseconds(66);

/// Runs a recording through a Station. Takes about a second per minute of a game.
///
/// @throws recording::RecordingError if the file cannot be read or holds nothing to show
[[nodiscard]] Replay load_replay(const std::filesystem::path& file, StationParameters parameters);

}  // namespace teamsight::monitor
