// monitor/station.cpp: see monitor/station.hpp.
#include "monitor/station.hpp"

#include <algorithm>
#include <utility>

#include "monitor/silence.hpp"

namespace teamsight::monitor {
namespace {

// Bounds for what strangers on the bus could make us keep.
constexpr std::size_t kMaxEventsPerUpdate = 256;
constexpr std::size_t kMaxProcesses = 64;
constexpr std::size_t kMaxInstances = 256;
constexpr std::size_t kMaxThumbnailsPerUpdate = 8;

// Two computers' monotonic clocks differ by more than this, unless both were just switched on.
constexpr Duration kLongestWay = std::chrono::seconds(2);
constexpr Duration kShown = std::chrono::seconds(2);

constexpr std::string_view kAgentPrefix = "agent/";
constexpr std::string_view kStation = "monitor";

std::string robot_name(RobotId robot) {
  return "Robot " + std::to_string(static_cast<unsigned>(robot));
}

std::string_view reason_of(Quarantine quarantine) {
  switch (quarantine) {
    case Quarantine::kNone:
      return "none";
    case Quarantine::kNoPosture:
      return "it does not know where it is";
    case Quarantine::kBiased:
      return "what it sees lies aside from what the others see";
    case Quarantine::kMirrored:
      return "it stands on the other half";
    case Quarantine::kKidnapped:
      return "its posture jumped";
    case Quarantine::kBabbling:
      return "too many or contradictory samples";
    case Quarantine::kDuplicateId:
      return "two processes speak under its id";
  }
  return "unknown";
}

}  // namespace

Station::Station(StationParameters parameters)
    : parameters_(std::move(parameters)),
      clocks_(kNobody, parameters_.boot),
      other_stations_(parameters_.other_station_gone_after) {}

Station::Watch& Station::watch_of(RobotId robot) {
  return robots_.try_emplace(robot, parameters_.window).first->second;
}

void Station::note(HostTime stamp, Level level, std::string text) {
  if (events_.size() + 1 == kMaxEventsPerUpdate) text = "more happened than can be listed";
  if (events_.size() < kMaxEventsPerUpdate) events_.push_back({stamp, level, std::move(text)});
}

void Station::note_boot(RobotId robot, Watch& watch, std::uint32_t boot, HostTime now) {
  if (boot == watch.boot) return;
  // A restarted process never speaks under its old boot id again; two processes take turns.
  const bool takes_turns = boot == watch.boot_before;
  const bool known =
      now - watch.shared_id_seen < parameters_.duplicate_for && watch.shared_id_seen != HostTime{};
  if (takes_turns) {
    if (!known) note(now, Level::kAlarm, robot_name(robot) + ": two processes speak under this id");
    watch.shared_id_seen = now;
  } else if (watch.boot != 0) {
    note(now, Level::kInfo, robot_name(robot) + ": its agent was started again");
  }
  watch.boot_before = std::exchange(watch.boot, boot);
}

void Station::note_silence(RobotId robot, Watch& watch, HostTime now) {
  if (now - watch.heard <= parameters_.silent_after) return;
  watch.alive = false;
  if (std::exchange(watch.is_reported_silent, true)) return;
  note(now, Level::kAlarm, robot_name(robot) + " is silent");
}

void Station::note_arrival(RobotId robot, Watch& watch, HostTime now) {
  if (!watch.was_heard) {
    note(now, Level::kInfo, robot_name(robot) + " joined");
  } else if (watch.is_reported_silent) {
    note(now, Level::kInfo, robot_name(robot) + " is back");
  }
  watch.was_heard = true;
  watch.is_reported_silent = false;
}

void Station::note_camera(RobotId robot, Watch& watch, bool is_lost, HostTime now) {
  if (!is_lost) {
    watch.camera_lost_since.reset();
    if (!std::exchange(watch.is_camera_reported, false)) return;
    return note(now, Level::kInfo, robot_name(robot) + ": its camera is back");
  }
  if (!watch.camera_lost_since) watch.camera_lost_since = now;
  if (now - *watch.camera_lost_since < parameters_.silent_after) return;
  if (std::exchange(watch.is_camera_reported, true)) return;
  note(now, Level::kAlarm, robot_name(robot) + ": its camera is lost");
}

void Station::note_versions(const std::set<std::string>& others, HostTime now) {
  std::string text;
  for (const std::string& version : others) text += (text.empty() ? "" : ", ") + version;
  if (text == std::exchange(other_versions_, text) || text.empty()) return;
  note(now, Level::kWarning, "Somebody here speaks " + text + kNotHeardHere);
}

bool Station::is_other_version(const bus::RobotState& state) const {
  return !parameters_.version.empty() && state.software_version != parameters_.version;
}

void Station::note_version(RobotId robot,
                           const Watch& watch,
                           const bus::RobotState& state,
                           HostTime now) {
  const bool is_known = watch.state && watch.state->software_version == state.software_version;
  if (is_known || !is_other_version(state)) return;
  note(now,
       Level::kWarning,
       robot_name(robot) + " runs version " + state.software_version + ", this station " +
           parameters_.version + ": install the same packages on every robot");
}

void Station::hear(const bus::Sample<bus::RobotState>& sample) {
  if (!sample.message) {
    const auto found = robot_of_instance_.find(sample.instance);
    if (found == robot_of_instance_.end()) return;
    watch_of(found->second).alive = sample.presence == bus::Presence::kAlive;
    return;
  }
  const bus::RobotState& state = *sample.message;
  const RobotId robot = state.id.robot;
  if (robot_of_instance_.size() < kMaxInstances) robot_of_instance_[sample.instance] = robot;
  Watch& watch = watch_of(robot);
  note_boot(robot, watch, state.id.boot, sample.received);
  note_arrival(robot, watch, sample.received);
  note_camera(robot, watch, state.camera_lost, sample.received);
  note_version(robot, watch, state, sample.received);
  watch.alive = sample.presence == bus::Presence::kAlive;
  watch.heard = sample.received;
  watch.state = state;
}

void Station::hear(const bus::Sample<bus::Sightings>& sample) {
  if (!sample.message) return;
  const bus::Sightings& sightings = *sample.message;
  Watch& watch = watch_of(sightings.id.robot);
  const HostTime received = sample.received;
  const auto way = way_of(sightings.id.robot, sightings.published, received);
  std::optional<Duration> since_exposure;
  if (way) since_exposure = *way + (sightings.published - sightings.exposure);
  watch.link.add(sightings.id, since_exposure, received);
  watch.sightings = sightings;
}

void Station::hear(const bus::Sample<bus::ClockEcho>& sample) {
  if (sample.message) clocks_.take_echo(*sample.message, sample.received);
}

void Station::hear(const bus::Sample<bus::LinePoints>& sample) {
  if (!sample.message) return;
  Watch& watch = watch_of(sample.message->id.robot);
  watch.line_points = sample.message;
  watch.line_points_heard = sample.received;
}

void Station::hear(const bus::Sample<bus::VirtualSensors>& sample) {
  if (!sample.message) return;
  Watch& watch = watch_of(sample.message->id.robot);
  watch.sensors = sample.message;
  watch.sensors_heard = sample.received;
}

void Station::hear(const bus::Sample<bus::Thumbnail>& sample) {
  if (!sample.message || thumbnails_.size() == kMaxThumbnailsPerUpdate) return;
  thumbnails_.push_back(*sample.message);
}

void Station::hear(const bus::Sample<WorldModel>& sample) {
  if (!sample.message) return;
  const WorldModel& world = *sample.message;
  const std::string leader =
      "The fusion of robot " + std::to_string(static_cast<unsigned>(world.id.robot));
  if (!world_) {
    const bool is_imported = world.id.robot == kNobody;
    note(sample.received,
         Level::kInfo,
         is_imported ? "The world model was imported: no fusion leads" : leader + " leads");
  } else if (world_->id.robot != world.id.robot) {
    note(sample.received,
         Level::kWarning,
         leader + " took over from that of robot " +
             std::to_string(static_cast<unsigned>(world_->id.robot)));
  }
  note_quarantines(world, sample.received);
  world_ = world;
  world_heard_ = sample.received;
}

void Station::note_quarantines(const WorldModel& world, HostTime now) {
  for (const WorldTeammate& teammate : world.teammates) {
    const auto found = robots_.find(teammate.robot);
    if (found == robots_.end()) continue;
    Watch& watch = found->second;
    if (watch.quarantine == teammate.quarantine) continue;
    watch.quarantine = teammate.quarantine;
    const bool is_released = teammate.quarantine == Quarantine::kNone;
    note(now,
         is_released ? Level::kInfo : Level::kWarning,
         robot_name(teammate.robot) +
             (is_released ? " is trusted again"
                          : " is in quarantine: " + std::string(reason_of(teammate.quarantine))));
  }
}

void Station::note_hint(const bus::ExplainedHint& hint, HostTime now) {
  const bool is_new = hint.command != hint_.command;
  const bool counts = hint.left > Duration{0};
  const bool counted = !is_new && hint_.left > Duration{0};
  if (counts && hint.track != 0 && std::exchange(hint_told_, hint.command) != hint.command) {
    note(now, Level::kInfo, "The ball hint counts: the ball there comes first");
  }
  if (!counts && counted) {
    note(now,
         Level::kInfo,
         hint_told_ == hint.command ? "The ball hint is over"
                                    : "The ball hint is over: no robot saw a ball there");
  }
  hint_ = hint;
  hint_heard_ = now;
}

std::optional<bus::ExplainedHint> Station::hint_at(HostTime now) const {
  bus::ExplainedHint hint = hint_;
  hint.left -= now - hint_heard_;
  if (hint.command == 0 || hint.left <= Duration{0}) return std::nullopt;
  return hint;
}

void Station::hear(const bus::Sample<bus::Explanation>& sample) {
  if (!sample.message) return;
  note_hint(sample.message->hint, sample.received);
  for (const bus::ExplainedRobot& robot : sample.message->robots) {
    const auto found = robots_.find(robot.robot);
    if (found != robots_.end()) found->second.explained = robot;
  }
}

/// Nobody hears his own Diagnostics, so those of a station are another's.
void Station::note_other_station(std::uint32_t boot, HostTime now) {
  if (!other_stations_.hear(boot, now)) return;
  note(now,
       Level::kWarning,
       "Another coach station is on " + parameters_.where +
           ": both may give orders, and the newest counts");
}

void Station::hear(const bus::Sample<bus::Diagnostics>& sample) {
  if (!sample.message) return;
  const bus::Diagnostics& diagnostics = *sample.message;
  if (diagnostics.process == kStation && !parameters_.is_recording)
    note_other_station(diagnostics.id.boot, sample.received);
  const auto known = processes_.find(diagnostics.process);
  if (known == processes_.end() && processes_.size() == kMaxProcesses) return;
  const bool was_healthy = known == processes_.end() || known->second.healthy;
  if (was_healthy && !diagnostics.healthy) {
    note(sample.received, Level::kWarning, diagnostics.process + ": " + diagnostics.message);
  } else if (!was_healthy && diagnostics.healthy) {
    note(sample.received, Level::kInfo, diagnostics.process + " is healthy again");
  }
  processes_[diagnostics.process] = diagnostics;
  const bool is_agent = diagnostics.process.starts_with(kAgentPrefix);
  const auto robot = robots_.find(diagnostics.id.robot);
  if (is_agent && robot != robots_.end()) robot->second.agent = diagnostics;
}

void Station::hear(const bus::Sample<bus::Truth>& sample) {
  if (!sample.message) return;
  truth_ = sample.message;
  truth_heard_ = sample.received;
}

void Station::count(std::string_view topic, const bus::ReadCounters& counters) {
  for (std::size_t i = 0; i < bus::kRejectReasons; ++i) {
    if (counters.rejected[i] == 0) continue;
    const std::string_view reason = bus::to_string(static_cast<bus::Reject>(i));
    rejected_[std::string(topic) + "." + std::string(reason)] = counters.rejected[i];
  }
}

RobotRow Station::row_of(RobotId robot, const Watch& watch, HostTime now) const {
  RobotRow row;
  row.robot = robot;
  row.alive = watch.alive;
  row.duplicate =
      watch.shared_id_seen != HostTime{} && now - watch.shared_id_seen < parameters_.duplicate_for;
  row.age = now - watch.heard;
  row.link = watch.link.report(now);
  row.state = watch.state;
  row.other_version = watch.state && is_other_version(*watch.state);
  row.agent = watch.agent;
  row.explained = watch.explained;
  row.sightings = watch.sightings;
  if (now - watch.line_points_heard < kShown) row.line_points = watch.line_points;
  if (now - watch.sensors_heard < kShown) row.sensors = watch.sensors;
  return row;
}

Update Station::update(HostTime now) {
  Update update;
  update.stamp = now;
  for (auto& [robot, watch] : robots_) {
    if (!watch.was_heard) continue;  // its Sightings came before its RobotState
    note_silence(robot, watch, now);
    update.robots.push_back(row_of(robot, watch, now));
  }
  update.world = world_;
  if (world_) update.world_age = now - world_heard_;
  if (truth_ && now - truth_heard_ < parameters_.world_late_after) update.truth = truth_;
  for (const auto& [name, diagnostics] : processes_) {
    if (!name.starts_with(kAgentPrefix)) update.processes.push_back(diagnostics);
  }
  for (const auto& [name, value] : rejected_) update.rejected.push_back({name, value});
  update.other_stations = other_stations_.count(now);
  update.hint = hint_at(now);
  update.thumbnails = std::exchange(thumbnails_, {});
  update.events = std::exchange(events_, {});
  update.silence = silence_of(update, surroundings());
  return update;
}

Duration Station::world_information_age(HostTime now) const {
  if (!world_) return Duration{0};
  const auto way = way_of(world_->id.robot, world_->stamp, world_heard_);
  return now - world_heard_ + way.value_or(Duration{0});
}

// Since a sample was stamped, if the robot's clock is known: measured, or else taken to be this
// computer's. A sample that seems to arrive before it was stamped, or seconds after, comes from
// another clock.
std::optional<Duration> Station::way_of(RobotId robot, PeerTime stamp, HostTime heard) const {
  const auto clock = clocks_.estimate(robot, heard);
  const Duration offset = clock ? clock->offset : Duration{0};
  const Duration way = heard - to_host_time(stamp, offset);
  const Duration slack = clock ? 3 * clock->sigma : Duration{0};
  if (way < -slack || way > kLongestWay) return std::nullopt;
  return std::max(way, Duration{0});
}

std::vector<const bus::RobotState*> Station::states() const {
  std::vector<const bus::RobotState*> states;
  for (const auto& [robot, watch] : robots_) {
    if (watch.state) states.push_back(&*watch.state);
  }
  return states;
}

Surroundings Station::surroundings() const {
  return {parameters_.where, parameters_.world_late_after, other_versions_, other_domains_};
}

std::vector<RobotId> Station::alive() const {
  std::vector<RobotId> robots;
  for (const auto& [robot, watch] : robots_) {
    if (watch.alive) robots.push_back(robot);
  }
  return robots;
}

}  // namespace teamsight::monitor
