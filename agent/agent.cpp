// agent/agent.cpp: see agent.hpp.
#include "agent/agent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agent/drift_complaint.hpp"
#include "agent/picture.hpp"
#include "bus/clock.hpp"
#include "process/identity_guard.hpp"
#include "process/temperature.hpp"

namespace teamsight::agent {
namespace {

using namespace std::chrono_literals;

// RobotState is a robot's sign of life, also without frames: three of these fit into its lease.
constexpr Duration kStatePeriod = 60ms;
constexpr Duration kShownPeriod = 500ms;
// The most that they take, see idl/README.md.
constexpr std::size_t kLinePointsBytes = 1288;
constexpr std::size_t kSensorsBytes = 952;
// Bytes, and bytes per second, of pictures: a twentieth of the league's 2.2 Mbit/s at most.
constexpr double kPictureRate = 13'000.0;
constexpr double kPictureBurst = 33'000.0;
constexpr std::size_t kDiagnosticsBytes = 1268;
constexpr Duration kShortestLoss = 150ms;  // a frame that is only late is no lost camera
constexpr Duration kLongestLoss = 2s;
constexpr Duration kPostureMissed = 3s;
constexpr Duration kRivalTold = 5s;
constexpr double kNewShare = 0.1;  // of one interval in the smoothed frame period

const char* to_text(vision::FrameReject reason) {
  switch (reason) {
    case vision::FrameReject::kWrongSize:
      return "frames.wrong_size";
    case vision::FrameReject::kWrongFormat:
      return "frames.wrong_format";
    case vision::FrameReject::kTruncated:
      return "frames.truncated";
  }
  return "frames.rejected";
}

std::string in_seconds(Duration duration) {
  const auto tenths = std::llround(10.0 * to_seconds(duration));
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " s";
}

}  // namespace

AgentBus::AgentBus(bus::Participant& team_domain, const bus::Participant& host)
    : team(&team_domain),
      states(team_domain),
      sightings(team_domain),
      line_points(team_domain),
      diagnostics(team_domain),
      peers(team_domain),
      commands(team_domain),
      worlds(team_domain),
      odometry(host),
      sensors(host),
      thumbnails(team_domain),
      shown_sensors(team_domain) {}

Agent::Agent(AgentIdentity identity,
             AgentBus& bus,
             FrameThread& frames,
             std::unique_ptr<vision::Perception> perception,
             std::unique_ptr<Locator> locator)
    : identity_(std::move(identity)),
      bus_(&bus),
      frames_(&frames),
      perception_(std::move(perception)),
      locator_(std::move(locator)),
      light_(perception_->light()),
      meter_("agent/" + std::to_string(identity_.robot), identity_.robot, identity_.boot),
      air_(*bus.team, "agent/" + std::to_string(identity_.robot)),
      picture_air_(kPictureRate, kPictureBurst),
      hearing_(*bus.team) {
  hearing_.watch(bus_->peers);
  hearing_.watch(bus_->worlds);
  hearing_.watch_always(air_.reports(), bus_->peers, bus_->worlds);
}

void Agent::join(bus::Loop& loop) {
  loop_ = &loop;
  loop.on_readable(frames_->event_fd(), [this] { turn(); });
  loop.on_readable(bus_->commands.event_fd(), [this] { listen_to_commands(); });
  loop.on_readable(bus_->peers.event_fd(), [this] { listen_to_peers(); });
  loop.on_readable(bus_->odometry.event_fd(), [this] { listen_to_wheels(); });
  loop.on_readable(bus_->worlds.event_fd(), [this] { listen_to_team(); });
  loop.on_readable(locator_->search_fd(), [this] { locator_->take_answer(); });
  loop.every(kStatePeriod / 3, [this] { keep_alive(); });
  loop.every(
      1s, [this] { diagnose(); }, 0.1);
  air_.attach(loop);
  hearing_.attach(loop);
}

void Agent::turn() {
  const Frame* frame = frames_->take();
  if (frame == nullptr) {
    return;
  }
  const process::StepTimer timer(meter_);
  const auto seen = perception_->see_with(
      frame->view(), [&](const auto& cues) { return locator_->see(cues, frame->exposure); });
  measure_rate(frame->exposure);
  if (!seen.has_value()) {
    count_reject(seen.error());
    return;
  }
  write({*seen, frame->exposure, frame->view()});
}

void Agent::write(const Seen& seen) {
  reject_.clear();
  posture_ = seen.observation->posture;
  exposure_ = seen.exposure;
  sees_ball_ = sees_ball(*seen.observation);
  drift_.take(seen.observation->drift, posture_.X_FR);
  light_.follow(*perception_, seen.frame, seen.observation->light, seen.exposure);
  carpet_luminance_ = static_cast<std::uint64_t>(seen.observation->carpet.luminance);
  const HostTime now = bus::host_now();
  if (posture_.status != PostureStatus::kLost) {
    posture_found_ = now;
  }
  write_state(now);
  if (!muted_) {
    const ObservationId id{identity_.robot, identity_.boot, ++sightings_count_};
    bus::Sightings sightings =
        sightings_of(*seen.observation, {id, seen.exposure, bus::host_now()});
    meter_.count("obstacles.beyond_bound", seen.observation->obstacles_left_out);
    meter_.count("air.obstacles_left_out", process::trim(sightings, air_.thrift()));
    bus_->sightings.write(sightings);
  }
  if (!seen.observation->sensors.empty()) {
    const ObservationId id{identity_.robot, identity_.boot, ++sensors_count_};
    bus_->sensors.write(sensors_of(*seen.observation, {id, seen.exposure, now}));
  }
  if (air_.thrift() == process::Thrift::kNone) show(seen, now);
}

/// What the coach's page has asked for, while the air has room for it.
void Agent::show(const Seen& seen, HostTime now) {
  if (now < line_points_until_ && now - line_points_written_ >= kShownPeriod) {
    show_line_points(seen, now);
  }
  if (now < pictures_until_ && now - picture_written_ >= kShownPeriod) show_picture(seen, now);
}

void Agent::show_line_points(const Seen& seen, HostTime now) {
  if (!air_.may_tell(kLinePointsBytes, now)) return;
  const ObservationId id{identity_.robot, identity_.boot, ++line_points_count_};
  bus_->line_points.write(line_points_of(*seen.observation, {id, seen.exposure, now}));
  line_points_written_ = now;
}

/// With the virtual sensors, which otherwise stay on the robot.
void Agent::show_picture(const Seen& seen, HostTime now) {
  picture_written_ = now;
  const auto picture = picture_of(seen.frame);
  if (!picture || !picture_air_.take(static_cast<double>(picture->jpeg.size()), now)) {
    meter_.count("Thumbnail.left_out");
    return;
  }
  const ObservationId id{identity_.robot, identity_.boot, ++thumbnail_count_};
  bus_->thumbnails.write(
      {id, stamp_of(seen.exposure), picture->width_px, picture->height_px, picture->jpeg});
  if (seen.observation->sensors.empty() || !air_.may_tell(kSensorsBytes, now)) return;
  bus_->shown_sensors.write(sensors_of(*seen.observation, {id, seen.exposure, now}));
}

void Agent::write_state(HostTime now) {
  bus::RobotState state;
  state.id = {identity_.robot, identity_.boot, ++state_count_};
  state.camera_lost = is_camera_lost(now);
  state.muted = muted_;
  // The posture was true at its exposure; without any frame the present stands for "unknown now".
  state.exposure = stamp_of(exposure_ == HostTime{} ? now : exposure_);
  state.published = stamp_of(now);
  state.posture = posture_;
  if (state.camera_lost) {
    state.posture.status = PostureStatus::kLost;
  }
  state.v_R = locator_->velocity(now);
  state.omega = locator_->omega(now);
  state.half_log_odds_team = locator_->team_log_odds();
  state.calibration_drift = drift_.report().drift_px;
  state.command_acknowledged = acknowledged_;
  state.sees_ball = sees_ball_ && !state.camera_lost;
  state.frame_rate = frame_period_ > 0.0 && !state.camera_lost ? 1.0 / frame_period_ : 0.0;
  state.cpu_load = cpu_load_;
  state.cpu_temperature = cpu_temperature_;
  state.software_version = identity_.software_version;
  bus_->states.write(state);
  state_written_ = now;
}

void Agent::keep_alive() {
  const HostTime now = bus::host_now();
  if (now - state_written_ >= kStatePeriod) {
    write_state(now);
  }
}

void Agent::measure_rate(HostTime exposure) {
  if (exposure_ == HostTime{} || exposure <= exposure_) {
    return;
  }
  const double interval = to_seconds(exposure - exposure_);
  const bool is_restart = frame_period_ == 0.0 || interval > 5.0 * frame_period_;
  frame_period_ = is_restart ? std::min(interval, 1.0)
                             : (1.0 - kNewShare) * frame_period_ + kNewShare * interval;
}

void Agent::count_reject(vision::FrameReject reason) {
  reject_ = to_text(reason);
  meter_.count(reject_);
}

bool Agent::is_camera_lost(HostTime now) const {
  if (exposure_ == HostTime{}) {
    return true;
  }
  const Duration three_frames = from_seconds(3.0 * frame_period_);
  return now - exposure_ > std::clamp<Duration>(three_frames, kShortestLoss, kLongestLoss);
}

std::string Agent::complaint(const SourceReport& source, HostTime now) const {
  if (rival_heard_ != HostTime{} && now - rival_heard_ < kRivalTold) {
    return rival_;
  }
  if (!reject_.empty()) {
    return reject_ + ": the frames are not what the camera file says";
  }
  if (!source.is_open) {
    return "camera: " + source.problem;
  }
  if (source.is_finished) {
    return "camera: the last frame of the files was given";
  }
  if (exposure_ == HostTime{}) {
    return "camera: no frame yet";
  }
  if (is_camera_lost(now)) {
    return "camera: no frame for " + in_seconds(now - exposure_);
  }
  if (now - posture_found_ > kPostureMissed) {
    return "posture lost: check field file, camera file, mask and light";
  }
  if (drift_.report().alarm) {
    return drift_complaint(drift_.report());
  }
  return light_.complaint();
}

void Agent::diagnose() {
  const HostTime now = bus::host_now();
  const SourceReport source = frames_->report();
  meter_.set("frames.read", source.frames);
  meter_.set("frames.overwritten", source.overwritten);
  meter_.set("camera.reopened", source.reopened);
  const vision::LocalisationCounts& posture = locator_->counts();
  meter_.set("posture.misses", posture.misses);
  meter_.set("posture.surprises", posture.surprises);
  meter_.set("posture.jumps", posture.jumps);
  meter_.set("posture.slips", posture.slips);
  meter_.set("posture.bad_input",
             posture.frames_not_finite + posture.frames_backwards + posture.inputs_not_finite +
                 posture.inputs_backwards);
  meter_.set("RobotState", bus_->states.counters());
  meter_.set("Sightings", bus_->sightings.counters());
  meter_.show("carpet.luminance", carpet_luminance_);
  light_.tell(meter_);
  meter_.set("Command", bus_->commands.counters());
  meter_.set("Odometry", bus_->odometry.counters());
  meter_.set("bus.rejoined", hearing_.times());
  bus::Diagnostics report = meter_.report(now);
  cpu_load_ = report.cpu_load;
  cpu_temperature_ = process::hottest_zone().value_or(0.0);
  report.message = complaint(source, now).substr(0, 95);
  report.healthy = report.message.empty();
  report.frame_age_ms = exposure_ == HostTime{} ? -1.0 : 1e3 * to_seconds(now - exposure_);
  hearing_.tell(report, now);
  air_.tell(report);
  if (air_.may_tell(kDiagnosticsBytes, now)) bus_->diagnostics.write(report);
}

void Agent::listen_to_commands() {
  const HostTime now = bus::host_now();
  bus_->commands.take(now, [this, now](const bus::Sample<bus::Command>& sample) {
    if (!sample.message.has_value()) {
      return;
    }
    const bus::Command& command = *sample.message;
    const bool is_for_me = command.target == kNobody || command.target == identity_.robot;
    if (!is_for_me || !(carried_out_.has(command) || carry_out(command, now))) {
      return;
    }
    carried_out_.note(command);
    acknowledged_ = command.command;
  });
}

bool Agent::carry_out(const bus::Command& command, HostTime now) {
  switch (command.kind) {
    case bus::CommandKind::kRelocate:
      locator_->place(command.X_FR, command.cov, now);
      return true;
    case bus::CommandKind::kMute:
      muted_ = true;
      return true;
    case bus::CommandKind::kUnmute:
      muted_ = false;
      return true;
    case bus::CommandKind::kLinePoints:
      line_points_until_ = now + command.duration;
      return true;
    case bus::CommandKind::kThumbnail:
      pictures_until_ = now + command.duration;
      return true;
    case bus::CommandKind::kBallHint:
      return false;  // for fusion, which acknowledges it
    case bus::CommandKind::kNone:
      break;
  }
  meter_.count("Command.not_understood");
  return false;
}

void Agent::listen_to_wheels() {
  bus_->odometry.take(bus::host_now(), [this](const bus::Sample<bus::Odometry>& sample) {
    if (sample.message.has_value() && sample.message->id.robot == identity_.robot) {
      locator_->roll(*sample.message);
    }
  });
}

void Agent::listen_to_team() {
  bus_->worlds.take(bus::host_now(), [this](const bus::Sample<WorldModel>& sample) {
    if (sample.message.has_value()) {
      locator_->hear(*sample.message, identity_.robot, sightings_count_);
    }
  });
}

void Agent::listen_to_peers() {
  const ObservationId own{identity_.robot, identity_.boot, state_count_};
  bus_->peers.take(bus::host_now(), [this, &own](const bus::Sample<bus::RobotState>& sample) {
    if (!sample.message.has_value()) {
      return;
    }
    const process::Rivalry rivalry = process::judge_rival(own, sample.message->id);
    if (rivalry == process::Rivalry::kNone) {
      return;
    }
    meter_.count("rival.samples");
    if (rival_heard_ == HostTime{}) {
      rival_ = process::words_on_rival(identity_.robot, bus_->peers.computer_of(sample.writer));
    }
    rival_heard_ = sample.received;
    if (rivalry == process::Rivalry::kYield) {
      yielded_ = true;
      loop_->stop();
    }
  });
}

}  // namespace teamsight::agent
