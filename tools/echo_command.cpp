// tools/echo_command.cpp: see tools/echo_command.hpp.
#include "tools/echo_command.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

#include "geometry/time.hpp"
#include "process/domains.hpp"
#include "settings/load.hpp"
#include "tools/echo_topic.hpp"

namespace teamsight::tools {
namespace {

struct Options {
  std::string topic;
  std::filesystem::path team;
  std::filesystem::path robot;
  std::optional<double> seconds;
  std::optional<std::uint64_t> count;
  process::DomainOptions domains;
  bool inside_host{false};
};

bus::DomainSettings domain_of(const Options& options) {
  std::optional<settings::RobotSettings> robot;
  if (!options.robot.empty()) robot = settings::load_robot(options.robot);
  const settings::TeamSettings team = robot ? robot->team : settings::load_team(options.team);
  if (!options.inside_host && !is_host_topic(options.topic)) {
    return process::team_domain(team, options.domains);
  }
  if (!robot && options.domains.host_tag.empty()) {
    throw std::runtime_error(
        "echo: " + options.topic +
        " stays inside one computer, expected --robot or --host-tag to say which");
  }
  return process::host_domain(team,
                              options.domains,
                              options.domains.host_tag.empty()
                                  ? process::default_host_tag(team, robot->id)
                                  : options.domains.host_tag);
}

int run(const Options& options) {
  static_cast<void>(is_host_topic(options.topic));  // an unknown topic is said first
  if (options.team.empty() == options.robot.empty()) {
    throw std::runtime_error("echo: expected either --team or --robot");
  }
  EchoRequest request;
  request.topic = options.topic;
  request.domain = domain_of(options);
  if (options.seconds) request.duration = from_seconds(*options.seconds);
  request.count = options.count;
  return echo(request);
}

std::string topic_help() {
  std::string text = "one of";
  for (const std::string_view topic : echo_topics()) text += " " + std::string(topic);
  return text;
}

}  // namespace

void add_echo_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("echo", "What is on the bus, now: JSON lines");
  command->add_option("topic", options->topic, topic_help())->required();
  command->add_option("--team", options->team, "team file (config/teams)");
  command->add_option("--robot", options->robot, "robot file (config/robots) instead of --team");
  command->add_option("--seconds", options->seconds, "ends after so many; else at Ctrl-C")
      ->check(CLI::PositiveNumber);
  command->add_option("--count", options->count, "ends after so many messages")
      ->check(CLI::PositiveNumber);
  command->add_flag("--host", options->inside_host, "in the domain inside the robot's computer");
  command->add_option("--team-domain", options->domains.team_domain, "DDS domain of the team")
      ->check(CLI::Range(0, 229));
  command->add_option(
      "--host-tag", options->domains.host_tag, "tag inside the computer; Truth: the match's");
  command->callback([options, &exit_code]() { exit_code = run(*options); });
}

}  // namespace teamsight::tools
