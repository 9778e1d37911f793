// fusion/service/service.cpp: see fusion/service/service.hpp.
#include "fusion/service/service.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "bus/clock.hpp"
#include "process/identity_guard.hpp"

namespace teamsight::fusion {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Duration kTurn = milliseconds(10);
// Over the air: soon after news, but never so often that it eats the team's share of it.
constexpr Duration kShortestPeriod = milliseconds(24);
constexpr Duration kLongestPeriod = milliseconds(30);
// A starting instance asks more often, so that peers' samples are not held back for long.
constexpr Duration kQuickProbes = milliseconds(200);
constexpr Duration kProbes = seconds(1);
constexpr Duration kStartPhase = seconds(3);
constexpr Duration kDiscovered = milliseconds(800);
constexpr Duration kRivalTold = seconds(5);
// When the air is full. Three of these still fit into a lease of 200 ms.
constexpr Duration kSlowPeriod = milliseconds(62);
constexpr double kJitter = 0.1;
// The most that they take, see idl/README.md.
constexpr std::size_t kExplanationBytes = 964;
constexpr std::size_t kDiagnosticsBytes = 1268;

Observation observation_of(const bus::Sightings& sightings, const ConvertedStamp& exposure) {
  return {sightings.id,
          exposure.time,
          exposure.sigma,
          sightings.posture,
          sightings.balls,
          sightings.obstacles};
}

bus::ExplainedTrack explained(const TrackReport& report) {
  bus::ExplainedTrack track;
  track.track = report.track;
  track.kind = report.is_ball ? bus::TrackKind::kBall : bus::TrackKind::kObstacle;
  track.supporters = report.supporters;
  track.rejected = report.rejected;
  // The topic counts seconds in 16 bits; a track older than 18 hours says 18 hours.
  track.born_ago = std::min(std::chrono::duration_cast<seconds>(report.born_ago), seconds(65535));
  track.nis = report.nis;
  return track;
}

bus::ExplainedRobot explained(const RobotReport& report) {
  bus::ExplainedRobot robot;
  robot.robot = report.robot;
  robot.trust = report.trust;
  robot.quarantine = report.quarantine;
  robot.accepted = report.accepted;
  robot.rejected_gate = report.rejected_gate;
  robot.rejected_late = report.rejected_late;
  robot.rejected_duplicate = report.rejected_duplicate;
  robot.rejected_posture = report.rejected_posture;
  return robot;
}

}  // namespace

Service::Service(bus::Participant& team,
                 const bus::Participant& host,
                 const ServiceIdentity& identity,
                 Fusion fusion)
    : identity_(identity),
      fusion_(std::move(fusion)),
      leadership_({identity.strength, identity.robot}, {.lease = team.lease()}),
      clocks_(identity.robot, identity.boot),
      meter_("fusion/" + std::to_string(identity.robot), identity.robot, identity.boot),
      air_(team, "fusion/" + std::to_string(identity.robot)),
      hearing_(team),
      sightings_(team),
      worlds_(team),
      probes_(team),
      echoes_(team),
      commands_(team),
      team_world_(team, identity.strength),
      host_world_(host, identity.strength),
      explanation_(team),
      probe_(team),
      echo_(team),
      diagnostics_(team),
      started_(bus::host_now()),
      last_intake_(started_) {
  hearing_.watch(sightings_);
  hearing_.watch(worlds_);
  hearing_.watch_beside(probes_, echoes_, air_.reports());
  hearing_.watch_beside(echoes_, probes_, air_.reports());
  hearing_.watch_always(air_.reports(), sightings_, probes_, echoes_);
}

void Service::attach(bus::Loop& loop) {
  loop_ = &loop;
  loop.on_readable(sightings_.event_fd(), [this] { take_sightings(bus::host_now()); });
  loop.on_readable(worlds_.event_fd(), [this] { take_worlds(bus::host_now()); });
  loop.on_readable(probes_.event_fd(), [this] { take_probes(bus::host_now()); });
  loop.on_readable(echoes_.event_fd(), [this] { take_echoes(bus::host_now()); });
  loop.on_readable(commands_.event_fd(), [this] { take_commands(bus::host_now()); });
  loop.every(kTurn, [this] { turn(bus::host_now()); });
  loop.every(
      milliseconds(500), [this] { publish_explanation(bus::host_now()); }, kJitter);
  loop.every(
      seconds(1), [this] { publish_diagnostics(bus::host_now()); }, kJitter);
  air_.attach(loop);
  hearing_.attach(loop);
}

void Service::take_sightings(HostTime now) {
  const process::StepTimer timer(meter_);
  sightings_.take(now, [&](const bus::Sample<bus::Sightings>& sample) {
    if (sample.message) take_sample(*sample.message, now);
  });
  if (has_news_) turn(now);
}

void Service::take_sample(const bus::Sightings& sightings, HostTime now) {
  const auto exposure = clocks_.convert(sightings.id.robot, sightings.exposure, now);
  if (!exposure) return meter_.count("Sightings.clock_unknown");
  switch (fusion_.insert(observation_of(sightings, *exposure), now)) {
    case Intake::kAccepted:
      has_news_ = true;
      last_intake_ = now;
      return;
    case Intake::kDuplicate:
      return meter_.count("Sightings.duplicate");
    case Intake::kTooOld:
      return meter_.count("Sightings.too_old");
    case Intake::kFromTheFuture:
      return meter_.count("Sightings.from_the_future");
    case Intake::kTooMany:
      return meter_.count("Sightings.too_many");
  }
}

void Service::take_worlds(HostTime now) {
  worlds_.take(now, [&](const bus::Sample<WorldModel>& sample) {
    if (!sample.message) return;
    const WorldModel& world = *sample.message;
    if (world.id.robot == identity_.robot) {
      if (world.id.boot != identity_.boot) meter_.count("WorldModel.duplicate_id");
      return;
    }
    leadership_.heard({world.strength, world.id.robot}, now);
    if (leadership_.leads(now)) return;
    const auto stamp = clocks_.convert(world.id.robot, world.stamp, now);
    fusion_.adopt_ids(world, stamp ? stamp->time : now);
  });
}

void Service::take_probes(HostTime now) {
  probes_.take(now, [&](const bus::Sample<bus::ClockProbe>& sample) {
    if (!sample.message) return;
    clocks_.take_probe(*sample.message, now);
    judge_rival(sample);
  });
  const HostTime sent = bus::host_now();
  if (const auto echo = clocks_.next_echo(sent)) echo_.write(*echo);
}

// Only a process that has just begun yields: later a forged packet could end it.
void Service::judge_rival(const bus::Sample<bus::ClockProbe>& sample) {
  const ObservationId own{identity_.robot, identity_.boot, clocks_.probes()};
  const process::Rivalry rivalry = process::judge_rival(own, sample.message->id);
  if (rivalry == process::Rivalry::kNone) return;
  meter_.count("rival.probes");
  if (rival_.empty()) {
    rival_ = process::words_on_rival(identity_.robot, probes_.computer_of(sample.writer));
  }
  rival_heard_ = sample.received;
  const bool is_new = sample.received - started_ < kStartPhase;
  has_yielded_ = has_yielded_ || (is_new && rivalry == process::Rivalry::kYield);
}

// Once the others have discovered it: what it says last is for the coach.
void Service::end_second(HostTime now) {
  const Duration said = last_reports_ * process::kBetweenLastReports;
  if (!has_yielded_ || now - started_ < kDiscovered + said) return;
  const std::string process = "fusion/" + std::to_string(identity_.robot);
  if (!last_report_) last_report_ = process::last_report(process, identity_.robot, rival_, now);
  diagnostics_.write(*last_report_);
  if (++last_reports_ == process::kLastReports) loop_->stop();
}

void Service::take_echoes(HostTime now) {
  echoes_.take(now, [&](const bus::Sample<bus::ClockEcho>& sample) {
    if (sample.message) clocks_.take_echo(*sample.message, now);
  });
}

// Every instance takes a hint alike, so that the next leader goes on with it.
void Service::take_commands(HostTime now) {
  commands_.take(now, [&](const bus::Sample<bus::Command>& sample) {
    if (!sample.message || sample.message->kind != bus::CommandKind::kBallHint) return;
    const bus::Command& command = *sample.message;
    if (std::exchange(hinted_, command.command) == command.command) return;
    fusion_.take_hint(
        {command.command, now, command.X_FR.origin(), command.cov.topLeftCorner<2, 2>()});
    meter_.count("Command.ball_hint");
    // The operator waits for it, however full the air is.
    if (leadership_.leads(now)) write_explanation(now);
  });
}

void Service::turn(HostTime now) {
  const bool leads = leadership_.leads(now);
  const Duration since = now - published_;
  if (since >= kLongestPeriod || (has_news_ && since >= kShortestPeriod)) {
    publish_world(now, leads);
  }
  publish_probe(now);
  end_second(now);
}

void Service::publish_world(HostTime now, bool leads) {
  // A late observation may have changed which one began a track: names stay as they were said.
  if (leads) fusion_.adopt_ids(last_world_, to_host_time(last_world_.stamp, Duration{0}));
  WorldModel world = fusion_.world_at(now);
  world.strength = identity_.strength;
  world.id = {identity_.robot, identity_.boot, ++host_count_};
  host_world_.write(world);
  if (leads) speak(world, now);
  last_world_ = std::move(world);
  published_ = now;
  has_news_ = false;
}

// Numbered apart from what the own host gets: what is left out here is not lost.
void Service::speak(WorldModel& world, HostTime now) {
  if (air_.thrift() >= process::Thrift::kSlowWorld && now - spoken_ < kSlowPeriod) return;
  world.id.sequence = ++air_count_;
  team_world_.write(world);
  spoken_ = now;
}

void Service::publish_probe(HostTime now) {
  const Duration period = now - started_ < kStartPhase ? kQuickProbes : kProbes;
  if (now - probed_ < period) return;
  probed_ = now;
  probe_.write(clocks_.next_probe(bus::host_now()));
}

void Service::publish_explanation(HostTime now) {
  if (!leadership_.leads(now) || !air_.may_tell(kExplanationBytes, now)) return;
  write_explanation(now);
}

void Service::write_explanation(HostTime now) {
  const Report report = fusion_.report_at(now);
  bus::Explanation explanation;
  ++explanation_count_;
  explanation.id = {identity_.robot, identity_.boot, explanation_count_};
  explanation.stamp = stamp_of(now);
  for (const TrackReport& track : report.tracks) explanation.tracks.push_back(explained(track));
  for (const RobotReport& robot : report.robots) {
    explanation.robots.push_back(explained(robot));
    if (const auto clock = clocks_.estimate(robot.robot, now)) {
      explanation.robots.back().clock_offset = clock->offset;
      explanation.robots.back().clock_sigma = clock->sigma;
    }
  }
  explanation.hint = {report.hint.number, report.hint.track, report.hint.left};
  explanation_.write(explanation);
}

void Service::publish_diagnostics(HostTime now) {
  meter_.set("Sightings", sightings_.counters());
  meter_.set("WorldModel", worlds_.counters());
  meter_.set("WorldModel.team", team_world_.counters());
  meter_.set("WorldModel.host", host_world_.counters());
  meter_.set("leads", leadership_.leads(now) ? 1 : 0);
  meter_.set("held", fusion_.held());
  meter_.set("bus.rejoined", hearing_.times());
  bus::Diagnostics diagnostics = meter_.report(now);
  const auto silent = std::chrono::duration_cast<seconds>(now - last_intake_);
  if (silent >= seconds(1)) {
    diagnostics.healthy = false;
    diagnostics.message = "no usable sightings for " + std::to_string(silent.count()) +
                          " s: are agents running on this domain?";
  }
  if (rival_heard_ != HostTime{} && now - rival_heard_ < kRivalTold) {
    diagnostics.healthy = false;
    diagnostics.message = rival_;
  }
  hearing_.tell(diagnostics, now);
  air_.tell(diagnostics);
  if (air_.may_tell(kDiagnosticsBytes, now)) diagnostics_.write(diagnostics);
}

}  // namespace teamsight::fusion
