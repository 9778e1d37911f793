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
#include "recording/recorder.hpp"

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
  bool alive{false};          ///< the writer's lease holds
  bool duplicate{false};      ///< two processes speak under this id
  bool other_version{false};  ///< it does not run this station's
  Duration age{0};            ///< since the last sample arrived
  LinkReport link;
  std::optional<bus::RobotState> state;          ///< the newest
  std::optional<bus::Diagnostics> agent;         ///< the newest of its agent
  std::optional<bus::ExplainedRobot> explained;  ///< by the leading fusion
  std::optional<bus::Sightings> sightings;       ///< the newest
  std::optional<bus::LinePoints> line_points;    ///< the newest, while asked for
  std::optional<bus::VirtualSensors> sensors;    ///< the newest, while pictures are asked for

  friend bool operator==(const RobotRow&, const RobotRow&) = default;
};

enum class ActionState : std::uint8_t { kWaiting, kDone, kNoAnswer };

/// What became of one order to the robots.
struct ActionReport {
  std::uint32_t command{0};
  std::string text;  ///< e.g. "relocate robot 3"
  ActionState state{ActionState::kWaiting};
  Duration age{0};  ///< since it was given

  friend bool operator==(const ActionReport&, const ActionReport&) = default;
};

/// The game, and how the referee box is reached.
struct RefereeReport {
  bus::GameState state;
  std::string last_command;      ///< empty: none yet
  bool has_box{false};           ///< an address was given
  bool tells_game{false};        ///< the robots hear the game from this station
  bool follows_game{false};      ///< they hear it from another, which this one shows
  double world_state_rate{0.0};  ///< Hz, over the last second
  std::uint64_t world_states_skipped{0};
  std::uint64_t refused{0};  ///< messages that could not be read, or not be sent

  friend bool operator==(const RefereeReport&, const RefereeReport&) = default;
};

/// The world as it would be without one robot.
struct WorldWithout {
  RobotId robot{kNobody};
  WorldModel world;

  friend bool operator==(const WorldWithout&, const WorldWithout&) = default;
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
  std::vector<bus::Thumbnail> thumbnails;   ///< since the update before
  std::optional<bus::ExplainedHint> hint;   ///< the ball hint that counts; nothing: none does
  std::uint32_t other_stations{0};          ///< coach stations heard beside this one
  std::optional<WorldWithout> without;      ///< while asked for
  std::optional<RefereeReport> referee;
  std::optional<recording::RecorderReport> recorder;  ///< nothing: not recording
  std::vector<ActionReport> actions;                  ///< of the last seconds, oldest first

  friend bool operator==(const Update&, const Update&) = default;
};

}  // namespace teamsight::monitor
