// fusion/service/main.cpp: the program `teamsight-fusion`: one fusion instance on one robot.
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

#include "bus/loop.hpp"
#include "fusion/service/service.hpp"
#include "process/domains.hpp"
#include "process/program.hpp"
#include "process/supervision.hpp"
#include "settings/load.hpp"

namespace {

using teamsight::bus::Participant;

struct CommandLine {
  std::string robot_file;
  teamsight::process::DomainOptions domains;
};

void describe(CLI::App& app, CommandLine& line) {
  app.add_option("--robot", line.robot_file, "robot file (config/robots/...)")->required();
  app.add_option("--team-domain", line.domains.team_domain, "instead of the team file's domain_id")
      ->check(CLI::Range(0, 229));
  app.add_option("--host-tag", line.domains.host_tag, "tag of the host domain");
}

int serve(const CommandLine& line) {
  namespace process = teamsight::process;
  const auto robot = teamsight::settings::load_robot(line.robot_file);
  const auto field = teamsight::settings::load_field(robot.team.field);
  teamsight::fusion::Parameters parameters;
  parameters.ball_radius = robot.team.ball_radius;
  parameters.robot_radius = robot.team.robot_radius;
  const std::string tag = line.domains.host_tag.empty()
                              ? process::default_host_tag(robot.team, robot.id)
                              : line.domains.host_tag;
  teamsight::bus::Loop loop;
  const auto keeps_trying = [&loop] {
    return loop.keeps_running();
  };
  auto team =
      Participant::join(process::team_domain(robot.team, line.domains, robot.id), keeps_trying);
  const auto host =
      Participant::join(process::host_domain(robot.team, line.domains, tag), keeps_trying);
  teamsight::fusion::Service service(team,
                                     host,
                                     {robot.id, robot.strength, process::draw_boot_id()},
                                     teamsight::fusion::Fusion(parameters, field));
  service.attach(loop);
  process::report_to_supervisor(loop);
  loop.run();
  if (service.has_yielded()) throw std::runtime_error(service.rival());
  return process::kDone;
}

}  // namespace

int main(int argc, char** argv) {
  return teamsight::process::run_program("teamsight-fusion", [&] {
    CLI::App app("Merges the team's observations into one world model.");
    CommandLine line;
    describe(app, line);
    if (const auto code = teamsight::process::parse_command_line(app, argc, argv)) return *code;
    return serve(line);
  });
}
