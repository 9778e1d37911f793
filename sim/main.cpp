// sim/main.cpp: the program `teamsight-sim`: a match whose cameras are pictures in FIFOs.
//
// One process per robot, because each robot's host domain has a tag of its own and a process can
// only be in one of them; all play the same match from the same seed. The first one tells the
// truth.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bus/clock.hpp"
#include "bus/ending_signals.hpp"
#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "bus/writer.hpp"
#include "process/domains.hpp"
#include "process/program.hpp"
#include "settings/load.hpp"
#include "sim/frame_rate.hpp"
#include "sim/robot_camera.hpp"
#include "sim/setup.hpp"
#include "vision/image.hpp"

namespace teamsight::sim {
namespace {

using namespace std::chrono_literals;

struct Options {
  std::string match;
  std::string frames;
  std::string team;
  double seconds{0.0};
  std::optional<std::uint32_t> seed;
  std::optional<double> rate_hz;
  bool rate_that_holds{false};
  HostTime start{};
  process::DomainOptions domains;
};

std::optional<int> parse(Options& options, int argc, const char* const* argv) {
  CLI::App app(
      "A simulated match: one omni camera per own robot, drawn into FRAMES/robotN.stream.");
  app.add_option("--match", options.match, "match file (config/matches)")->required();
  app.add_option("--frames,--streams", options.frames, "directory for the FIFOs; made if missing")
      ->required();
  app.add_option("--team", options.team, "team file instead of the match's");
  app.add_option("--seconds", options.seconds, "end after so long; 0: never")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--seed", options.seed, "instead of the match's");
  CLI::Option* rate = app.add_option("--rate", options.rate_hz, "frames per s, not the match's")
                          ->check(CLI::Range(1.0, 100.0));
  app.add_flag("--rate-that-holds",
               options.rate_that_holds,
               "as many frames per s as this computer can draw beside a team; it says how many")
      ->excludes(rate);
  app.add_option("--team-domain", options.domains.team_domain, "DDS domain instead of the team's")
      ->check(CLI::Range(0, 229));
  app.add_option("--host-tag", options.domains.host_tag, "tag of the domain that gets the truth");
  app.footer(scenario_help());
  return process::parse_command_line(app, argc, argv);
}

Setup load(const Options& options) {
  Setup setup = load_setup(options.match, options.team, options.seed);
  const vision::CameraParameters& camera = setup.camera;
  if (!vision::has_even_size(camera.format, camera.width_px, camera.height_px)) {
    throw std::runtime_error(
        setup.match.camera.string() + ": size: found " + std::to_string(camera.width_px) + " x " +
        std::to_string(camera.height_px) + ", expected an even size for this format");
  }
  return setup;
}

void end_after(bus::Loop& loop, HostTime start, double seconds) {
  if (seconds <= 0.0) {
    return;
  }
  loop.every(20ms, [&loop, start, seconds] {
    if (to_seconds(bus::host_now() - start) >= seconds) {
      loop.stop();
    }
  });
}

// A robot's odometry on its own domain, while there is a team.
class Drive {
 public:
  Drive(const settings::TeamSettings& team, const process::DomainOptions& domains, RobotId robot)
      : host_(bus::Participant::join(
            process::host_domain(team, domains, process::default_host_tag(team, robot)))),
        writer_(host_),
        id_{robot, process::draw_boot_id(), 0} {}

  void publish(const RobotCamera::Count& count) {
    const WheelParameters wheels;
    ++id_.sequence;
    writer_.write({id_,
                   stamp_of(count.stamp),
                   count.X_DR,
                   count.v_R,
                   count.omega,
                   wheels.sigma_v,
                   wheels.sigma_omega,
                   false});
  }

 private:
  bus::Participant host_;
  bus::Writer<bus::Odometry> writer_;
  ObservationId id_;
};

// What all robots' processes are forked with: the tables of an eye are in memory once.
struct Stage {
  Setup setup;
  std::optional<Eye> eye;  // of every robot; nothing if each has defects of its own
  FrameTally tally;
};

int play_robot(const Options& options, Stage& stage, std::size_t player) {
  const Setup& setup = stage.setup;
  bus::Loop loop;  // before any thread: it takes SIGINT and SIGTERM for all of them
  const RobotId robot = setup.parameters.own.at(player);
  FramePipe pipe(std::filesystem::path(options.frames) /
                 ("robot" + std::to_string(robot) + ".stream"));
  // Exposures are spread over the frame period, so that the drawing is too.
  const double phase = static_cast<double>(player) / static_cast<double>(setup.match.robots.size());
  RobotCamera camera(
      player,
      {options.start, setup.match.frame_rate_hz, phase},
      Match(setup.parameters, setup.field),
      stage.eye.has_value() ? *std::move(stage.eye) : make_eye(setup, player, setup.camera.format),
      pipe);
  std::optional<Drive> drive;
  if (setup.match.team.has_value()) {
    drive.emplace(*setup.match.team, options.domains, robot);
  }
  loop.every(2ms, [&] {
    camera.tick(bus::host_now());
    stage.tally.set(player, camera.frames());
  });
  loop.every(10ms, [&] {
    if (drive.has_value()) {
      drive->publish(camera.count(bus::host_now()));
    }
  });
  end_after(loop, options.start, options.seconds);
  loop.run();
  return process::kDone;
}

bus::Truth truth_of(const MatchState& state, const ObservationId& id, HostTime stamp) {
  const Ball& ball = state.balls.front();
  bus::Truth truth{id, stamp_of(stamp), ball.p_FB, ball.v_FB, {}};
  for (const Player& player : state.players) {
    if (player.on_field) {
      truth.robots.push_back({player.number, player.X_FR, player.v_FR});
    }
  }
  return truth;
}

// Robots whose process has ended; the others play on.
std::size_t count_ended(std::vector<pid_t>& children) {
  std::size_t ended = 0;
  for (pid_t& child : children) {
    if (child > 0 && ::waitpid(child, nullptr, WNOHANG) == child) {
      child = -1;
    }
    if (child < 0) {
      ++ended;
    }
  }
  return ended;
}

void say_of_cameras(const std::string& what) {
  std::printf("cameras: %s\n", what.c_str());
  std::fflush(stdout);  // nothing of it may be left for a fork to say again
}

// Now and then a line about the rate, if there is something new to say.
void watch_rate(bus::Loop& loop, const Stage& stage, RateJudge& judge) {
  constexpr auto kWindow = 10s;
  loop.every(kWindow, [&, last = bus::host_now()]() mutable {
    const HostTime now = bus::host_now();
    if (const auto news = judge.judge(stage.tally, to_seconds(now - std::exchange(last, now)))) {
      say_of_cameras(*news);
    }
  });
}

int tell_truth(const Options& options, const Stage& stage, std::vector<pid_t>& children) {
  const Setup& setup = stage.setup;
  bus::Loop loop;
  RateJudge judge(stage.tally.cameras(), setup.match.frame_rate_hz);
  watch_rate(loop, stage, judge);
  Match match(setup.parameters, setup.field);
  std::optional<bus::Participant> host;
  std::optional<bus::Writer<bus::Truth>> writer;
  if (setup.match.team.has_value()) {
    const std::string tag = options.domains.host_tag.empty() ? setup.match.team->name + ".match"
                                                             : options.domains.host_tag;
    host = bus::Participant::join(process::host_domain(*setup.match.team, options.domains, tag));
    writer.emplace(*host);
  }
  ObservationId id{kNobody, process::draw_boot_id(), 0};
  loop.every(10ms, [&] {
    const HostTime now = bus::host_now();
    match.advance_to(std::max(0.0, to_seconds(now - options.start) - kBeforeKickOff));
    if (writer.has_value()) {
      ++id.sequence;
      writer->write(
          truth_of(match.state(),
                   id,
                   std::min(now, options.start + from_seconds(kBeforeKickOff + match.time()))));
    }
  });
  loop.every(100ms, [&] {
    if (count_ended(children) == children.size()) {
      loop.stop();
    }
  });
  end_after(loop, options.start, options.seconds);
  loop.run();
  return process::kDone;
}

// Ends with the parent, whatever ends that.
void be_child_of(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) {
    ::_exit(process::kDone);  // it ended before the line above
  }
}

// Before any thread or bus: what fork() copies is only memory.
pid_t start_robot(const Options& options, Stage& stage, std::size_t player) {
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child != 0) {
    return child;
  }
  be_child_of(parent);
  const auto play = [&] {
    return play_robot(options, stage, player);
  };
  ::_exit(process::run_program("teamsight-sim", play));
}

std::vector<pid_t> start_robots(const Options& options, Stage& stage) {
  std::vector<pid_t> children;
  for (std::size_t player = 0; player < stage.setup.match.robots.size(); ++player) {
    children.push_back(start_robot(options, stage, player));
  }
  return children;
}

void end_robots(const std::vector<pid_t>& children) {
  for (const pid_t child : children) {
    if (child > 0) {
      ::kill(child, SIGTERM);
      ::waitpid(child, nullptr, 0);
    }
  }
}

Stage set_stage(const Options& options) {
  Setup setup = load(options);
  std::optional<Eye> eye;
  if (setup.match.picture.defect_seed == 0) {
    eye = make_eye(setup, 0, setup.camera.format);
  }
  const std::size_t cameras = setup.match.robots.size();
  return {std::move(setup), std::move(eye), FrameTally(cameras)};
}

std::string fit_rate(Stage& stage) {
  settings::MatchSettings& match = stage.setup.match;
  std::optional<Eye> own;
  if (!stage.eye.has_value()) {
    own = make_eye(stage.setup, 0, stage.setup.camera.format);
  }
  const Duration draw = time_to_draw(stage.setup, own.has_value() ? *own : *stage.eye);
  const unsigned cores = std::max(std::thread::hardware_concurrency(), 1U);
  match.frame_rate_hz = rate_that_holds(draw, match.robots.size(), cores);
  return fmt::format("this computer has {} core{} and draws one picture in {:.0f} ms",
                     cores,
                     cores == 1 ? "" : "s",
                     to_seconds(draw) * 1e3);
}

// The rate that is asked for, or one that fits; says which and why.
void choose_rate(const Options& options, Stage& stage) {
  settings::MatchSettings& match = stage.setup.match;
  std::string why = "as the match file says";
  if (options.rate_that_holds) {
    why = fit_rate(stage);
  } else if (options.rate_hz.has_value()) {
    match.frame_rate_hz = *options.rate_hz;
    why = "as asked";
  }
  say_of_cameras(fmt::format("{} of {}x{} at {:g} Hz: {}",
                             match.robots.size(),
                             stage.setup.camera.width_px,
                             stage.setup.camera.height_px,
                             match.frame_rate_hz,
                             why));
}

int run(Options options) {
  Stage stage = set_stage(options);
  std::filesystem::create_directories(options.frames);
  choose_rate(options, stage);
  options.start = bus::host_now();
  const bus::HeldSignals held;  // or the second of two ends it before its robots
  std::vector<pid_t> children = start_robots(options, stage);
  try {
    const int code = tell_truth(options, stage, children);
    end_robots(children);
    return code;
  } catch (...) {
    end_robots(children);
    throw;
  }
}

}  // namespace
}  // namespace teamsight::sim

int main(int argc, char** argv) {
  return teamsight::process::run_program("teamsight-sim", [&] {
    teamsight::sim::Options options;
    if (const auto code = teamsight::sim::parse(options, argc, argv)) {
      return *code;
    }
    return teamsight::sim::run(options);
  });
}
