// tests/network/scenarios_twin.cpp: a second computer comes up with the robot file of a first one.
#include <algorithm>
#include <fstream>

#include "tests/network/stage.hpp"

namespace teamsight::network {
namespace {

constexpr RobotId kTwice = 3;
constexpr std::size_t kFrameBytes = std::size_t{640} * 480 * 2;

using test::ChildProcess;

bool is_one_line(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n') == 1 && text.ends_with('\n');
}

// A program of the second computer.
ChildProcess start(Stage& stage,
                   const std::string& program,
                   const std::vector<std::string>& more,
                   const std::string& command = "") {
  // A computer of its own: starting there takes nothing from the processors of the others.
  std::vector<std::string> argv{"/usr/bin/nice", "-n", "10", test::program(program).string()};
  if (!command.empty()) argv.push_back(command);
  argv.insert(argv.end(),
              {"--robot",
               stage.team.file("robots/bench" + std::to_string(kTwice) + ".textproto").string()});
  argv.insert(argv.end(), more.begin(), more.end());
  return ChildProcess(stage.hosts.on_host(stage.hosts.count() - 1, argv));
}

// What the coach's computer hears, from before the second computer is there.
ChildProcess listen(Stage& stage) {
  ChildProcess ear(stage.hosts.on_host(stage.team.host(stage.team.robots()) + 1,
                                       {test::program("teamsight").string(),
                                        "echo",
                                        "Diagnostics",
                                        "--team",
                                        stage.team.file("teams/bench.textproto").string()}));
  stage.outcome.expect(test::wait_until([&] { return !ear.out().empty(); }, seconds(3)),
                       "the coach hears the team");
  return ear;
}

void expect_end(Stage& stage, ChildProcess& process, const std::string& name) {
  const std::string where = "(" + Hosts::address(stage.team.host(kTwice)) + ") too: give one robot";
  const auto code = process.wait_exit(seconds(10));
  stage.outcome.say(name + " on the second computer: " + process.err());
  stage.outcome.expect(code == 2, name + " ends with exit code 2");
  stage.outcome.expect(is_one_line(process.err()), name + " says one line");
  stage.outcome.expect(process.err().find(where) != std::string::npos,
                       name + " says where the other one is, and what to do");
}

void expect_told(Stage& stage, const ChildProcess& ear, const std::string& process) {
  const auto is_told = [&] {
    return ear.out().find("second " + process) != std::string::npos;
  };
  stage.outcome.expect(test::wait_until(is_told, seconds(1)),
                       "the coach is told of the second " + process);
}

}  // namespace

Outcome twin(const ScenarioOptions& options) {
  Stage stage("twin", options, team_of(options), 1);
  stage.start();
  std::ofstream(stage.team.file("frame.yuyv")) << std::string(kFrameBytes, '\0');
  const std::int64_t from = now_ns();
  const ChildProcess ear = listen(stage);
  ChildProcess agent =
      start(stage,
            "teamsight-agent",
            {"--loop", "--source", "raw:" + stage.team.file("frame.yuyv").string()});
  ChildProcess fusion = start(stage, "teamsight-fusion", {});
  expect_end(stage, agent, "teamsight-agent");
  expect_end(stage, fusion, "teamsight-fusion");
  expect_told(stage, ear, "agent/3");
  expect_told(stage, ear, "fusion/3");

  ChildProcess doctor = start(stage, "teamsight", {"--seconds", "1.5"}, "doctor");
  stage.outcome.expect(doctor.wait_exit(seconds(10)) == 1, "the doctor's answer is no");
  stage.outcome.expect(doctor.err().starts_with("id: robot id 3 is used on "),
                       "the doctor begins with the id");
  const Knowledge worst = stage.report("the team meanwhile", {from, now_ns()});
  stage.outcome.expect(worst.served >= 0.99, "every behaviour has a model of at most 300 ms");
  stage.outcome.expect(worst.robots == everybody(6), "all robots in all models");
  stage.outcome.expect(worst.leaders == std::set<int>{6}, "nobody else takes over");
  return stage.outcome;
}

}  // namespace teamsight::network
