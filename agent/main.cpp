// agent/main.cpp: the program `teamsight-agent`: one robot's camera onto the bus.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>
#include <poll.h>

#include "agent/agent.hpp"
#include "agent/open_source.hpp"
#include "bus/clock.hpp"
#include "process/domains.hpp"
#include "process/identity_guard.hpp"
#include "process/program.hpp"
#include "process/supervision.hpp"
#include "settings/load.hpp"
#include "settings/shirt_complaint.hpp"

namespace teamsight::agent {
namespace {

using namespace std::chrono_literals;

// How long an older process with the same id has to make itself heard: discovery and a few states.
constexpr Duration kListenForRivals = 1s;

struct Options {
  std::string robot;
  std::string source;
  std::string prior;
  std::string field;
  std::string camera;
  double rate_hz{-1.0};
  bool loop{false};
  process::DomainOptions domains;
};

std::optional<int> parse(Options& options, int argc, const char* const* argv) {
  CLI::App app("One robot's camera onto the bus: posture, ball and obstacles of every frame.");
  app.add_option("--robot", options.robot, "robot file (config/robots)")->required();
  app.add_option("--source",
                 options.source,
                 "raw:FILE,... image:FILE,... video:FILE gst:PIPELINE v4l2:DEVICE stream:PATH")
      ->required();
  app.add_option("--rate-hz",
                 options.rate_hz,
                 "at most so many frames per second; 0: as they come (files: 15, live: 0)");
  app.add_flag("--loop", options.loop, "begin files again after the last frame");
  app.add_option("--prior", options.prior, "where the robot is at first: x_m,y_m,theta_rad");
  app.add_option("--field", options.field, "field file instead of the team's");
  app.add_option("--camera", options.camera, "camera file instead of the robot's");
  app.add_option("--team-domain", options.domains.team_domain, "DDS domain instead of the team's");
  app.add_option("--host-tag", options.domains.host_tag, "tag of the robot's own DDS domain");
  return process::parse_command_line(app, argc, argv);
}

Pose<Field, Robot> parse_prior(const std::string& text) {
  std::istringstream stream(text);
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;
  char first = 0;
  char second = 0;
  std::string rest;
  stream >> x >> first >> y >> second >> theta;
  const bool is_whole = stream && first == ',' && second == ',' && !(stream >> rest);
  if (!is_whole || !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(theta)) {
    throw std::runtime_error("--prior: found \"" + text + "\", expected x_m,y_m,theta_rad");
  }
  return {x, y, theta};
}

vision::StartSide start_side_of(settings::StartSide side) {
  switch (side) {
    case settings::StartSide::kOwnHalf:
      return vision::StartSide::kOwnHalf;
    case settings::StartSide::kOpponentHalf:
      return vision::StartSide::kOpponentHalf;
    case settings::StartSide::kUnknown:
      break;
  }
  return vision::StartSide::kUnknown;
}

// Everything from files, read and checked.
struct Setup {
  settings::RobotSettings robot;
  FieldModel field;
  vision::CameraParameters camera;
  SourceChoice source;
};

Setup load(const Options& options) {
  Setup setup;
  setup.robot = settings::load_robot(options.robot);
  using Path = std::filesystem::path;
  const Path field = options.field.empty() ? setup.robot.team.field : Path(options.field);
  const Path camera = options.camera.empty() ? setup.robot.camera : Path(options.camera);
  setup.field = settings::load_field(field);
  setup.camera = settings::load_camera(camera);
  setup.source = parse_source(options.source);
  return setup;
}

// Nothing else is wrong then, so the robot plays.
void complain_of_shirts(const Setup& setup) {
  const std::string words =
      settings::shirt_complaint(setup.robot.team.shirts, setup.camera.colours);
  if (!words.empty()) std::fprintf(stderr, "teamsight-agent: %s\n", words.c_str());
}

// Decoders give BGR, whatever the camera on the robot gives.
vision::CameraParameters camera_for(const Setup& setup) {
  vision::CameraParameters camera = setup.camera;
  const SourceKind kind = setup.source.kind;
  if (kind == SourceKind::kPictures || kind == SourceKind::kVideoFile ||
      kind == SourceKind::kGstreamer) {
    camera.format = vision::PixelFormat::kBgr;
  }
  return camera;
}

std::unique_ptr<Locator> make_locator(const Options& options,
                                      const Setup& setup,
                                      const vision::HeadTilt& head) {
  vision::LocalisationParameters parameters;
  parameters.start_side = start_side_of(setup.robot.start_side);
  parameters.tilt = head;
  auto locator = std::make_unique<Locator>(setup.field, parameters);
  if (!options.prior.empty()) {
    const Eigen::Vector3d sigma(0.5, 0.5, 0.3);  // what a person can pace out and see
    locator->place(parse_prior(options.prior), sigma.cwiseAbs2().asDiagonal(), bus::host_now());
  }
  return locator;
}

// Another process with this robot id, if one has been heard: on which computer.
std::optional<bus::Computer> find_rival(bus::Reader<bus::RobotState>& peers, RobotId robot) {
  std::optional<bus::Computer> rival;
  peers.take(bus::host_now(), [&](const bus::Sample<bus::RobotState>& sample) {
    if (sample.message.has_value() && sample.message->id.robot == robot) {
      rival = peers.computer_of(sample.writer);
    }
  });
  return rival;
}

// Waits until a rival has had the time to be heard, and the coach the time to discover this
// process; or the process is to end.
void refuse_second(AgentBus& topics, RobotId robot, const bus::Loop& loop) {
  const HostTime until = bus::host_now() + kListenForRivals;
  std::optional<bus::Computer> rival;
  while (loop.keeps_running() && bus::host_now() < until) {
    pollfd waiting{topics.peers.event_fd(), POLLIN, 0};
    ::poll(&waiting, 1, 20);
    if (const auto heard = find_rival(topics.peers, robot)) rival = heard;
  }
  if (!rival.has_value()) return;
  const std::string words = process::words_on_rival(robot, *rival);
  const bus::Diagnostics report =
      process::last_report("agent/" + std::to_string(robot), robot, words, bus::host_now());
  for (int i = 0; i < process::kLastReports && loop.keeps_running(); ++i) {
    topics.diagnostics.write(report);
    std::this_thread::sleep_for(process::kBetweenLastReports);
  }
  throw std::runtime_error(words);
}

int run(const Options& options) {
  bus::Loop loop;  // before any thread: it takes SIGINT and SIGTERM for all of them
  const Setup setup = load(options);
  if (!options.prior.empty()) (void)parse_prior(options.prior);  // a mistake shows before all else
  const vision::CameraParameters camera = camera_for(setup);
  complain_of_shirts(setup);
  const PictureLayout layout{camera.width_px, camera.height_px, camera.format};
  const auto open = [source = setup.source, layout, again = options.loop] {
    return open_source(source, layout, again);
  };
  const bool is_live = may_come_later(setup.source.kind);
  std::unique_ptr<FrameSource> first = is_live ? nullptr : open();

  const settings::TeamSettings& team = setup.robot.team;
  auto perception = std::async(std::launch::async, [&] {
    vision::PerceptionParameters parameters{team.ball_radius, team.robot_radius};
    parameters.shirts = team.shirts;
    return std::make_unique<vision::Perception>(camera, setup.field, parameters);
  });
  const auto keeps_trying = [&loop] {
    return loop.keeps_running();
  };
  auto team_bus = bus::Participant::join(
      process::team_domain(team, options.domains, setup.robot.id), keeps_trying);
  const std::string tag = options.domains.host_tag.empty()
                              ? process::default_host_tag(team, setup.robot.id)
                              : options.domains.host_tag;
  const auto host_bus =
      bus::Participant::join(process::host_domain(team, options.domains, tag), keeps_trying);
  AgentBus topics(team_bus, host_bus);
  refuse_second(topics, setup.robot.id, loop);
  // Commands that were waiting are about the time before this start.
  topics.commands.take(bus::host_now(), [](const bus::Sample<bus::Command>&) {});

  FrameThread frames(open,
                     std::move(first),
                     options.rate_hz >= 0 ? options.rate_hz
                     : is_live            ? 0.0
                                          : 15.0);
  std::unique_ptr<vision::Perception> eye = perception.get();
  std::unique_ptr<Locator> locator = make_locator(options, setup, eye->head());
  Agent agent({setup.robot.id, process::draw_boot_id(), TEAMSIGHT_VERSION},
              topics,
              frames,
              std::move(eye),
              std::move(locator));
  agent.join(loop);
  process::report_to_supervisor(loop);
  loop.run();
  if (agent.has_yielded()) {
    throw std::runtime_error(agent.rival());
  }
  return process::kDone;
}

}  // namespace
}  // namespace teamsight::agent

int main(int argc, char** argv) {
  return teamsight::process::run_program("teamsight-agent", [&] {
    teamsight::agent::Options options;
    if (const auto code = teamsight::agent::parse(options, argc, argv)) {
      return *code;
    }
    return teamsight::agent::run(options);
  });
}
