// examples/behaviour/main.cpp: asks for the freshest world and says who goes to the ball.
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "client/team_world.hpp"
#include "examples/behaviour/attacker.hpp"

namespace {

struct CommandLine {
  std::string robot_file;
  teamsight::TeamWorldOptions options;
  int decisions{0};
  int period_ms{100};
};

void describe(CLI::App& app, CommandLine& line) {
  app.add_option("--robot", line.robot_file, "robot file of this robot")->required();
  app.add_option("--team-domain", line.options.team_domain, "instead of the team file's domain_id")
      ->check(CLI::Range(0, 229));
  app.add_option("--host-tag", line.options.host_tag, "tag of the host domain");
  app.add_option("--decisions", line.decisions, "how many to make; 0: until it is ended");
  app.add_option("--period-ms", line.period_ms, "between decisions")->check(CLI::Range(1, 10000));
}

const char* name_of(teamsight::Source source) {
  switch (source) {
    case teamsight::Source::kLeader:
      return "leader";
    case teamsight::Source::kOwnHost:
      return "own_host";
    case teamsight::Source::kNone:
      break;
  }
  return "none";
}

nlohmann::json decision_of(const teamsight::World& world,
                           const std::optional<teamsight::bus::GameState>& game,
                           teamsight::RobotId me) {
  nlohmann::json json{{"source", name_of(world.source)},
                      {"maker", nullptr},
                      {"age_ms", nullptr},
                      {"ball_x_m", nullptr},
                      {"ball_y_m", nullptr},
                      {"attacker", nullptr},
                      {"time_to_ball_s", nullptr},
                      {"i_go", false},
                      {"running", nullptr}};
  if (game) json["running"] = game->running;
  if (world.source == teamsight::Source::kNone) return json;
  json["maker"] = world.model.id.robot;
  json["age_ms"] = 1e3 * teamsight::to_seconds(world.age);
  if (!world.model.balls.empty()) {
    json["ball_x_m"] = world.model.balls.front().p_FB.x;
    json["ball_y_m"] = world.model.balls.front().p_FB.y;
  }
  if (const auto attacker = behaviour::choose_attacker(world.model)) {
    json["attacker"] = attacker->robot;
    json["time_to_ball_s"] = attacker->time_to_ball;
    json["i_go"] = attacker->robot == me;
  }
  return json;
}

void decide(const CommandLine& line) {
  teamsight::TeamWorld team(line.robot_file, line.options);
  auto next = std::chrono::steady_clock::now();
  for (int made = 0; line.decisions == 0 || made < line.decisions; ++made) {
    next += std::chrono::milliseconds(line.period_ms);
    std::this_thread::sleep_until(next);
    std::cout << decision_of(team.freshest(), team.game(), team.robot()) << std::endl;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App app("Says who goes to the ball: one JSON line per decision.");
    CommandLine line;
    describe(app, line);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return app.exit(error) == 0 ? 0 : 2;
    }
    decide(line);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "teamsight-behaviour: %s\n", error.what());
    return 2;
  }
}
