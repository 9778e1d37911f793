// tools/doctor_command.cpp: see doctor_command.hpp.
#include "tools/doctor_command.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "bus/clock.hpp"
#include "bus/computer.hpp"
#include "bus/loop.hpp"
#include "bus/profile.hpp"
#include "bus/reader.hpp"
#include "process/domains.hpp"
#include "process/elsewhere.hpp"
#include "process/program.hpp"
#include "settings/load.hpp"
#include "tools/doctor_findings.hpp"

namespace teamsight::tools {
namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path robot;
  std::string device{"/dev/video0"};
  fs::path disk{"."};
  std::vector<int> expected;
  double seconds{3.0};
  process::DomainOptions domains;
};

/// Listens to everything that says how the team is.
class Ear {
 public:
  Ear(const bus::Participant& team, const bus::Participant& host)
      : states_(team),
        worlds_(team),
        explanations_(team),
        diagnostics_(team),
        own_worlds_(host) {}

  void listen(Duration duration, Observed& seen) {
    bus::Loop loop;
    const HostTime end = bus::host_now() + duration;
    loop.every(std::chrono::milliseconds(20), [&] {
      take(seen);
      if (bus::host_now() >= end) loop.stop();
    });
    loop.run();
    seen.state_writers = states_.live_writers();
    for (const auto& [process, bps] : rates_) seen.team_bps += bps;
    for (const auto& [writer, computer] : own_speakers_) {
      if (!computer.is_this && !computer.address.empty()) seen.rival = bus::to_text(computer);
    }
  }

 private:
  void take(Observed& seen) {
    const HostTime now = bus::host_now();
    states_.take(now, [&](const bus::Sample<bus::RobotState>& sample) {
      if (!sample.message) return;
      const bus::RobotState& state = *sample.message;
      if (state.id.robot == seen.robot && !own_speakers_.contains(sample.writer)) {
        own_speakers_[sample.writer] = states_.computer_of(sample.writer);
      }
      seen.heard[state.id.robot] = {
          state.frame_rate, state.camera_lost, state.calibration_drift, state.software_version};
    });
    worlds_.take(now, [&](const bus::Sample<WorldModel>& sample) {
      if (sample.message) seen.leader = sample.message->id.robot;
    });
    own_worlds_.take(now, [&](const bus::Sample<WorldModel>& sample) {
      if (sample.message) seen.own_fusion = true;
    });
    explanations_.take(now, [&](const bus::Sample<bus::Explanation>& sample) {
      if (!sample.message) return;
      for (const auto& robot : sample.message->robots) {
        seen.clock_sigmas[robot.robot] = robot.clock_sigma;
      }
    });
    diagnostics_.take(now, [&](const bus::Sample<bus::Diagnostics>& sample) {
      if (sample.message) rates_[sample.message->process] = sample.message->wire_bps;
    });
  }

  bus::Reader<bus::RobotState> states_;
  bus::Reader<WorldModel> worlds_;
  bus::Reader<bus::Explanation> explanations_;
  bus::Reader<bus::Diagnostics> diagnostics_;
  bus::Reader<WorldModel> own_worlds_;
  std::map<std::string, double> rates_;
  std::map<std::uint64_t, bus::Computer> own_speakers_;
};

double days_since(fs::file_time_type time) {
  using Days = std::chrono::duration<double, std::ratio<86400>>;
  return std::chrono::duration_cast<Days>(fs::file_time_type::clock::now() - time).count();
}

// Days until the certificate runs out, as openssl reads it: in steps, since it only says yes or no.
std::optional<double> certificate_days(const fs::path& certificate) {
  const auto lasts = [&](long days) {
    const std::string command =
        fmt::format("openssl x509 -noout -checkend {} -in '{}' >/dev/null 2>&1",
                    days * 86400,
                    certificate.string());
    return std::system(command.c_str()) == 0;  // NOLINT(concurrency-mt-unsafe): one thread
  };
  if (std::system("openssl version >/dev/null 2>&1") != 0) return std::nullopt;  // NOLINT
  long low = -1;
  long high = 4000;
  while (high - low > 1) {
    const long middle = (low + high) / 2;
    (lasts(middle) ? low : high) = middle;
  }
  return static_cast<double>(low);
}

Observed look(const Options& options) {
  const settings::RobotSettings robot = settings::load_robot(options.robot);
  static_cast<void>(settings::load_field(robot.team.field));
  static_cast<void>(settings::load_camera(robot.camera));
  const bus::DomainSettings domain = process::team_domain(robot.team, options.domains, robot.id);
  Observed seen;
  seen.robot = robot.id;
  seen.software_version = TEAMSIGHT_VERSION;
  seen.profile = domain.profile_path;
  seen.card = bus::load_profile(domain.profile_path, "").card;
  seen.cards_up = bus::cards_up().value_or(std::vector<std::string>{});
  seen.domain_id = domain.domain_id;
  seen.secured = !domain.identity.empty();
  if (seen.secured)
    seen.certificate_days = certificate_days(fs::path(domain.identity) / "identity.pem");
  seen.camera_device = options.device;
  seen.camera_exists = fs::exists(options.device);
  seen.calibration_days = days_since(fs::last_write_time(robot.camera));
  seen.disk_free_gb = 1e-9 * static_cast<double>(fs::space(options.disk).available);
  seen.expected.insert(robot.team.robots.begin(), robot.team.robots.end());
  if (!options.expected.empty()) seen.expected.clear();
  for (const int id : options.expected) seen.expected.insert(static_cast<RobotId>(id));
  const std::string tag = options.domains.host_tag.empty()
                              ? process::default_host_tag(robot.team, robot.id)
                              : options.domains.host_tag;
  bus::OtherDomains others;
  const auto team = bus::Participant::join(domain);
  const auto host = bus::Participant::join(process::host_domain(robot.team, options.domains, tag));
  Ear(team, host).listen(from_seconds(options.seconds), seen);
  seen.other_domains = bus::to_text(
      process::without_own(others.heard(bus::host_now()), robot.team, options.domains));
  return seen;
}

int examine(const Options& options) {
  bool all_ok = true;
  for (const Finding& finding : findings(look(options))) {
    fmt::print("{}\n",
               nlohmann::ordered_json{{"check", finding.check},
                                      {"ok", finding.ok},
                                      {"found", finding.found},
                                      {"do", finding.what_to_do}}
                   .dump());
    if (!finding.ok) {
      fmt::print(stderr, "{}: {}: {}\n", finding.check, finding.found, finding.what_to_do);
    }
    all_ok = all_ok && finding.ok;
  }
  return all_ok ? process::kDone : process::kAnswerIsNo;
}

}  // namespace

void add_doctor_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("doctor", "Is this robot ready, and if not, what to do");
  command->add_option("--robot", options->robot, "robot file (config/robots)")->required();
  command
      ->add_option("--expect",
                   options->expected,
                   "robots that should be heard, e.g. 1,2,3; without: the team file's")
      ->delimiter(',')
      ->check(CLI::Range(1, static_cast<int>(kMaxRobotId)));
  command->add_option("--device", options->device, "the camera's")->capture_default_str();
  command->add_option("--disk", options->disk, "where recordings go")->capture_default_str();
  command->add_option("--seconds", options->seconds, "how long to listen")
      ->capture_default_str()
      ->check(CLI::Range(0.5, 60.0));
  command->add_option("--team-domain", options->domains.team_domain, "DDS domain of the team")
      ->check(CLI::Range(0, 229));
  command->add_option("--host-tag", options->domains.host_tag, "tag of the robot's own DDS domain");
  command->callback([options, &exit_code]() { exit_code = examine(*options); });
}

}  // namespace teamsight::tools
