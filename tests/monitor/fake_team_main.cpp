// tests/monitor/fake_team_main.cpp: the process `teamsight-fake-team`: one robot, or one fusion, of
// the fake team.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "agent/picture.hpp"
#include "bus/clock.hpp"
#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"
#include "process/meter.hpp"
#include "process/program.hpp"
#include "tests/monitor/fake_team.hpp"

namespace teamsight::test {
namespace {

constexpr Duration kFrame = std::chrono::milliseconds(40);
constexpr Duration kExposedBefore = std::chrono::milliseconds(27);

/// A camera that sees the seasons change: grey, from dark to bright.
bus::Thumbnail fake_picture(const ObservationId& id, HostTime exposure) {
  std::vector<std::uint8_t> grey(std::size_t{64} * 48);
  for (std::size_t i = 0; i < grey.size(); ++i) {
    grey[i] = static_cast<std::uint8_t>(4 * (i % 64) + id.sequence);
  }
  const auto picture = agent::picture_of({grey, 64, 48, vision::PixelFormat::kGrey});
  return {id, stamp_of(exposure), picture->width_px, picture->height_px, picture->jpeg};
}

/// Says `is_healthy` once a second under the name of a process.
class Health {
 public:
  Health(const bus::Participant& participant, const std::string& process, const ObservationId& id)
      : writer_(participant),
        meter_(process, id.robot, id.boot) {}

  void tell() { writer_.write(meter_.report(bus::host_now())); }

 private:
  bus::Writer<bus::Diagnostics> writer_;
  process::ProcessMeter meter_;
};

/// What a robot makes of its orders: all are acknowledged and told on stdout, but by robot 5.
class Obedience {
 public:
  Obedience(const bus::Participant& participant, bus::Loop& loop, RobotId robot)
      : reader_(participant),
        robot_(robot) {
    loop.on_readable(reader_.event_fd(), [this]() { listen(); });
  }

  [[nodiscard]] std::uint32_t acknowledged() const { return acknowledged_; }

  [[nodiscard]] bool is_muted() const { return is_muted_; }

  /// Whether the operator looks at its camera.
  [[nodiscard]] bool is_watched() const { return bus::host_now() < watched_until_; }

 private:
  static constexpr RobotId kDeaf = 5;

  void listen() {
    reader_.take(bus::host_now(), [this](const bus::Sample<bus::Command>& sample) {
      if (!sample.message || robot_ == kDeaf) return;
      const bus::Command& command = *sample.message;
      const bool is_mine = command.target == kNobody || command.target == robot_;
      if (!is_mine || command.command == acknowledged_) return;
      acknowledged_ = command.command;
      if (command.kind == bus::CommandKind::kMute) is_muted_ = true;
      if (command.kind == bus::CommandKind::kUnmute) is_muted_ = false;
      if (command.kind == bus::CommandKind::kThumbnail) {
        watched_until_ = bus::host_now() + command.duration;
      }
      std::printf("{\"command\": %u, \"x_m\": %.3f, \"y_m\": %.3f, \"theta_rad\": %.3f}\n",
                  static_cast<unsigned>(command.kind),
                  command.X_FR.x(),
                  command.X_FR.y(),
                  command.X_FR.theta());
      std::fflush(stdout);
    });
  }

  bus::Reader<bus::Command> reader_;
  RobotId robot_;
  std::uint32_t acknowledged_{0};
  bool is_muted_{false};
  HostTime watched_until_;
};

void run_robot(const bus::Participant& participant, bus::Loop& loop, RobotId robot) {
  ObservationId id{robot, process::draw_boot_id(), 0};
  const Obedience obedience(participant, loop, robot);
  bus::Writer<bus::RobotState> states(participant);
  bus::Writer<bus::Sightings> sightings(participant);
  bus::Writer<bus::VirtualSensors> sensors(participant);
  bus::Writer<bus::Thumbnail> pictures(participant);
  Health health(participant, "agent/" + std::to_string(robot), id);
  loop.every(kFrame, [&]() {
    ++id.sequence;
    const HostTime exposure = bus::host_now() - kExposedBefore;
    bus::RobotState state = fake_state(id, exposure);
    state.command_acknowledged = obedience.acknowledged();
    state.muted = obedience.is_muted();
    states.write(state);
    if (!obedience.is_muted()) sightings.write(fake_sightings(id, exposure));
    if (!obedience.is_watched() || id.sequence % 12 != 0) return;
    sensors.write(fake_sensors(id, exposure));
    pictures.write(fake_picture(id, exposure));
  });
  loop.every(std::chrono::seconds(1), [&]() { health.tell(); });
  loop.run();
}

void run_fusion(const bus::Participant& participant, bus::Loop& loop, RobotId host) {
  constexpr Duration kHintLasts = std::chrono::seconds(8);
  ObservationId id{host, process::draw_boot_id(), 0};
  bus::Reader<bus::Command> commands(participant);
  std::uint32_t hint = 0;
  HostTime hinted{};
  bus::Writer<WorldModel> worlds(participant, 30);
  bus::Writer<bus::Explanation> explanations(participant);
  Health health(participant, "fusion/" + std::to_string(host), id);
  loop.every(std::chrono::milliseconds(33), [&]() {
    ++id.sequence;
    worlds.write(fake_world(id, bus::host_now()));
  });
  loop.on_readable(commands.event_fd(), [&]() {
    commands.take(bus::host_now(), [&](const bus::Sample<bus::Command>& sample) {
      if (!sample.message || sample.message->kind != bus::CommandKind::kBallHint) return;
      if (std::exchange(hint, sample.message->command) != hint) hinted = sample.received;
    });
  });
  loop.every(std::chrono::milliseconds(500), [&]() {
    const HostTime now = bus::host_now();
    bus::Explanation explanation = fake_explanation(id, now);
    const Duration left = std::max(Duration{0}, hinted + kHintLasts - now);
    if (hint != 0) explanation.hint = {hint, fake_world(id, now).balls.at(0).track, left};
    explanations.write(explanation);
  });
  loop.every(std::chrono::seconds(1), [&]() { health.tell(); });
  loop.run();
}

int run(int argc, char** argv) {
  if (argc != 6) {
    throw std::runtime_error("usage: teamsight-fake-team robot|fusion ID DOMAIN PROFILE TAG");
  }
  const auto robot = static_cast<RobotId>(std::strtoul(argv[2], nullptr, 10));
  if (robot == kNobody || robot > kFakeRobots) throw std::runtime_error("ID: expected 1 to 5");
  bus::Loop loop;
  const auto domain = static_cast<std::uint32_t>(std::strtoul(argv[3], nullptr, 10));
  const bus::Participant participant = bus::Participant::join({domain, argv[4], argv[5]});
  std::puts("{\"ready\": true}");
  std::fflush(stdout);
  if (std::string(argv[1]) == "fusion") {
    run_fusion(participant, loop, robot);
  } else {
    run_robot(participant, loop, robot);
  }
  return process::kDone;
}

}  // namespace
}  // namespace teamsight::test

int main(int argc, char** argv) {
  return teamsight::process::run_program("teamsight-fake-team",
                                         [&]() { return teamsight::test::run(argc, argv); });
}
