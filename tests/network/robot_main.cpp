// tests/network/robot_main.cpp: a robot without a camera: sightings of the bench's match on the
// bus, and a record of every world model that the robot's behaviour could have used.
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <unistd.h>

#include "bus/clock.hpp"
#include "bus/loop.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"
#include "client/world_choice.hpp"
#include "process/air_share.hpp"
#include "process/domains.hpp"
#include "process/hearing.hpp"
#include "process/meter.hpp"
#include "process/program.hpp"
#include "settings/load.hpp"
#include "tests/fusion/scenario.hpp"
#include "tests/network/match.hpp"
#include "tests/network/sight.hpp"
#include "tests/network/writer_list.hpp"

namespace teamsight::network {
namespace {

using fusion::test::Eye;

constexpr double kSees_m = 8.0;
constexpr Duration kExposedBefore = std::chrono::milliseconds(20);
constexpr Duration kChoicePeriod = std::chrono::milliseconds(20);

struct Options {
  std::string robot;
  std::string log;
  std::string writers;
  int speak_as{0};  ///< 0: under its own id
  double rate_hz{30.0};
  std::int64_t clock_ahead_s{0};
  std::int64_t clock_step_s{3600};  // between the clocks of two neighbours
};

/// The robot's eye and mouth.
class Speaker {
 public:
  Speaker(bus::Participant& team, RobotId robot, Duration clock_ahead)
      : states_(team),
        sightings_(team),
        diagnostics_(team),
        id_{robot, process::draw_boot_id(), 0},
        clock_ahead_(clock_ahead),
        eye_(robot, id_.boot),
        random_(robot),
        meter_("agent/" + std::to_string(robot), robot, id_.boot),
        air_(team, "agent/" + std::to_string(robot)),
        peers_(team),
        hearing_(team) {
    hearing_.watch(peers_);
  }

  /// What else the process reads.
  void hear(const bus::Reader<WorldModel>& leader) {
    hearing_.watch(leader);
    hearing_.watch_beside(air_.reports(), peers_, leader);
  }

  void attach(bus::Loop& loop, double rate_hz) {
    loop.every(from_seconds(1.0 / rate_hz), [this] { speak(); });
    loop.every(
        std::chrono::seconds(1), [this] { report(); }, 0.1);
    air_.attach(loop);
    loop.on_readable(peers_.event_fd(),
                     [this] { peers_.take(bus::host_now(), [](const auto&) {}); });
    hearing_.attach(loop);
  }

 private:
  void speak() {
    const HostTime exposure = bus::host_now() - kExposedBefore;
    const MatchTime time = exposure.time_since_epoch() - clock_ahead_;
    look(exposure, time);
    ++id_.sequence;
    write_state(exposure);
    write_sightings(exposure);
  }

  void report() {
    const HostTime now = bus::host_now();
    meter_.set("bus.rejoined", hearing_.times());
    bus::Diagnostics report = meter_.report(now);
    hearing_.tell(report, now);
    air_.tell(report);
    diagnostics_.write(report);
  }

  void look(HostTime exposure, MatchTime time) {
    const auto X_FR = robot_at(id_.robot, time);
    eye_.look(X_FR, exposure, &random_);
    const Eigen::Vector2d own(X_FR.x(), X_FR.y());
    const auto is_near = [&](const Point<Field>& p) {
      return (p.vector() - own).norm() < kSees_m;
    };
    if (const auto ball = ball_at(time); is_near(ball)) eye_.see_ball(ball, &random_);
    for (const auto& opponent : opponents_at(time)) {
      if (is_near(opponent)) eye_.see_obstacle(opponent, &random_);
    }
    for (RobotId other = 1; other <= kRobots; ++other) {
      const auto X_FO = robot_at(other, time);
      const Point<Field> p{X_FO.x(), X_FO.y()};
      if (other != id_.robot && is_near(p)) eye_.see_obstacle(p, &random_);
    }
  }

  void write_state(HostTime exposure) {
    bus::RobotState state;
    state.id = id_;
    state.exposure = stamp_of(exposure);
    state.published = stamp_of(bus::host_now());
    state.posture = eye_.frame().posture;
    state.sees_ball = !eye_.frame().balls.empty();
    state.frame_rate = 30.0;
    state.software_version = TEAMSIGHT_VERSION;
    states_.write(state);
  }

  void write_sightings(HostTime exposure) {
    bus::Sightings sightings;
    sightings.id = id_;
    sightings.exposure = stamp_of(exposure);
    sightings.published = stamp_of(bus::host_now());
    sightings.posture = eye_.frame().posture;
    sightings.balls = eye_.frame().balls;
    sightings.obstacles = eye_.frame().obstacles;
    process::trim(sightings, air_.thrift());
    sightings_.write(sightings);
  }

  bus::Writer<bus::RobotState> states_;
  bus::Writer<bus::Sightings> sightings_;
  bus::Writer<bus::Diagnostics> diagnostics_;
  ObservationId id_;
  Duration clock_ahead_;
  Eye eye_;
  fusion::test::Random random_;
  process::ProcessMeter meter_;
  process::AirShare air_;
  bus::Reader<bus::RobotState> peers_;
  process::Hearing hearing_;
};

/// Writes down every world model that comes.
class Witness {
 public:
  Witness(const bus::Participant& team, const bus::Participant& host, const Options& options)
      : leader_(team),
        own_host_(host),
        choice_({}),
        clock_ahead_(std::chrono::seconds(options.clock_ahead_s)),
        clock_step_(std::chrono::seconds(options.clock_step_s)),
        log_(::open(options.log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600)) {
    if (log_ < 0) throw std::runtime_error("cannot write " + options.log);
  }

  ~Witness() { ::close(log_); }

  Witness(const Witness&) = delete;
  Witness& operator=(const Witness&) = delete;

  [[nodiscard]] const bus::Reader<WorldModel>& leader() const { return leader_; }

  void attach(bus::Loop& loop) {
    loop.on_readable(leader_.event_fd(), [this] {
      const HostTime now = bus::host_now();
      leader_.take(now, [&](const bus::Sample<WorldModel>& sample) {
        if (!sample.message) return;
        choice_.heard_leader(*sample.message, now);
        note(*sample.message, Channel::kLeader, Source::kLeader, now);
      });
    });
    loop.on_readable(own_host_.event_fd(), [this] {
      const HostTime now = bus::host_now();
      own_host_.take(now, [&](const bus::Sample<WorldModel>& sample) {
        if (!sample.message) return;
        choice_.heard_own_host(*sample.message);
        note(*sample.message, Channel::kOwnHost, Source::kOwnHost, now);
      });
    });
    loop.every(kChoicePeriod, [this] {
      const HostTime now = bus::host_now();
      const World world = choice_.freshest(now);
      note(world.model, Channel::kChoice, world.source, now);
    });
  }

 private:
  void note(const WorldModel& world, Channel channel, Source source, HostTime now) const {
    Sight sight;
    sight.at_ns = (now.time_since_epoch() - clock_ahead_).count();
    sight.channel = channel;
    sight.source = static_cast<std::uint8_t>(source);
    sight.maker = world.id.robot;
    sight.boot = world.id.boot;
    sight.sequence = world.id.sequence;
    // Robot r lives on host r - 1, and the hosts' clocks are a known step apart.
    const MatchTime about = world.stamp.time_since_epoch() - clock_step_ * world.id.robot;
    sight.age_ms = static_cast<float>(1e3 * to_seconds(Duration(sight.at_ns) - about));
    for (const WorldTeammate& mate : world.teammates) {
      if (mate.age < std::chrono::seconds(1)) {
        sight.robots = static_cast<std::uint8_t>(sight.robots | 1U << (mate.robot - 1U));
      }
    }
    note_ball(world, about, sight);
    for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
      sight.obstacle_tracks.at(i) = world.obstacles[i].track;
    }
    [[maybe_unused]] const auto written = ::write(log_, &sight, sizeof sight);
  }

  static void note_ball(const WorldModel& world, MatchTime about, Sight& sight) {
    sight.ball_error_x_m = sight.ball_error_y_m = std::numeric_limits<float>::quiet_NaN();
    if (world.balls.empty()) return;
    const WorldBall& ball = world.balls.front();
    const Point<Field> truth = ball_at(about);
    sight.ball_error_x_m = static_cast<float>(ball.p_FB.x - truth.x);
    sight.ball_error_y_m = static_cast<float>(ball.p_FB.y - truth.y);
    sight.ball_var_m2 = static_cast<float>(ball.cov_p(0, 0) + ball.cov_p(1, 1));
    sight.ball_track = ball.track;
  }

  bus::Reader<WorldModel> leader_;
  bus::Reader<WorldModel> own_host_;
  WorldChoice choice_;
  Duration clock_ahead_;
  Duration clock_step_;
  int log_;
};

int run(const Options& options) {
  bus::Loop loop;
  const auto robot = settings::load_robot(options.robot);
  const std::string tag = process::default_host_tag(robot.team, robot.id);
  const auto keeps_trying = [&loop] {
    return loop.keeps_running();
  };
  auto team = bus::Participant::join(process::team_domain(robot.team, {}, robot.id), keeps_trying);
  const auto host = bus::Participant::join(process::host_domain(robot.team, {}, tag), keeps_trying);
  const auto said = static_cast<RobotId>(options.speak_as);
  Speaker speaker(
      team, said == kNobody ? robot.id : said, std::chrono::seconds(options.clock_ahead_s));
  Witness witness(team, host, options);
  witness.attach(loop);
  speaker.attach(loop, options.rate_hz);
  speaker.hear(witness.leader());
  loop.run();
  if (!options.writers.empty()) list_writers(team, options.writers);
  return process::kDone;
}

}  // namespace
}  // namespace teamsight::network

int main(int argc, char** argv) {
  return teamsight::process::run_program("teamsight-bench-robot", [&] {
    teamsight::network::Options options;
    CLI::App app("A robot of the test bench of hosts.");
    app.add_option("--robot", options.robot, "robot file")->required();
    app.add_option("--log", options.log, "where the sights go")->required();
    app.add_option("--speak-as", options.speak_as, "another robot's id in what it says");
    app.add_option("--writers", options.writers, "where all writers are named at the end");
    app.add_option("--rate-hz", options.rate_hz, "frames a second");
    app.add_option("--clock-ahead-s", options.clock_ahead_s, "of this host against the test");
    app.add_option("--clock-step-s", options.clock_step_s, "between the clocks of neighbours");
    if (const auto code = teamsight::process::parse_command_line(app, argc, argv)) return *code;
    return teamsight::network::run(options);
  });
}
