// monitor/update.hpp: what the coach station shows at one moment, as values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bus/messages.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::monitor {

/// How much an event asks of the operator.
enum class Level : std::uint8_t {
  kInfo,     ///< good to know
  kWarning,  ///< the team plays on with less
  kAlarm,    ///< somebody has to act
};

/// Something that happened once and stays in the log.
struct Event {
  HostTime stamp;
  Level level{Level::kInfo};
  std::string text;

  friend bool operator==(const Event&, const Event&) = default;
};

/// How well one robot's samples arrive, over the last seconds.
struct LinkReport {
  double rate{0.0};                     ///< frames that arrived, Hz
  double loss{0.0};                     ///< share of frames that never came, in [0, 1]
  std::optional<Duration> latency_p50;  ///< exposure to arrival; nothing: the clocks do not compare
  std::optional<Duration> latency_p95;
  std::uint64_t received{0};  ///< frames since the station started

  friend bool operator==(const LinkReport&, const LinkReport&) = default;
};

/// Everything the station knows of one robot.
struct RobotRow {
  RobotId robot{kNobody};
  bool alive{false};      ///< the writer's lease holds
  bool duplicate{false};  ///< two processes speak under this id
  Duration age{0};        ///< since the last sample arrived
  LinkReport link;
  std::optional<bus::RobotState> state;          ///< the newest
  std::optional<bus::Diagnostics> agent;         ///< the newest of its agent
  std::optional<bus::ExplainedRobot> explained;  ///< by the leading fusion

  friend bool operator==(const RobotRow&, const RobotRow&) = default;
};

/// What the page shows at one moment.
struct Update {
  HostTime stamp;
  std::optional<WorldModel> world;          ///< the leader's newest; nothing: none yet
  Duration world_age{0};                    ///< since it arrived
  std::vector<RobotRow> robots;             ///< by id
  std::vector<Event> events;                ///< since the update before, oldest first
  std::string silence;                      ///< why nothing shows; empty when all is well
  std::optional<bus::Truth> truth;          ///< while it is fresh
  std::vector<bus::Diagnostics> processes;  ///< newest of every process that is no agent, by name
  std::vector<bus::Counter> rejected;       ///< samples this station dropped, "Topic.reason"

  friend bool operator==(const Update&, const Update&) = default;
};

}  // namespace teamsight::monitor
