// tests/network/bench_main.cpp: the scenarios and the soak as a command. See README.md.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "process/program.hpp"
#include "tests/network/hosts.hpp"
#include "tests/network/scenarios.hpp"

namespace teamsight::network {
namespace {

bool show(const Outcome& outcome) {
  std::printf("== %s\n", outcome.scenario.c_str());
  for (const std::string& line : outcome.lines) std::printf("%s\n", line.c_str());
  for (const std::string& claim : outcome.broken) std::printf("NOT: %s\n", claim.c_str());
  std::fflush(stdout);
  return outcome.broken.empty();
}

int run_scenarios(const std::vector<std::string>& names, const ScenarioOptions& options) {
  bool all_hold = true;
  for (const Scenario& scenario : all_scenarios()) {
    const bool is_wanted =
        names.empty() || std::find(names.begin(), names.end(), scenario.name) != names.end();
    if (is_wanted) all_hold = show(scenario.run(options)) && all_hold;
  }
  return all_hold ? process::kDone : process::kAnswerIsNo;
}

int run(int argc, char** argv) {
  ScenarioOptions options;
  std::vector<std::string> names;
  double soak_minutes = 0.0;
  CLI::App app("Computers in a box: a team of real processes on a network that breaks.");
  app.add_option("scenario", names, "which; without: all (--list)");
  app.add_option("--profile", options.profile, "of config/dds")->capture_default_str();
  app.add_option("--seed", options.seed, "of everything that is drawn")->capture_default_str();
  app.add_option("--length", options.length, "factor of the observed times")->capture_default_str();
  app.add_option("--soak-minutes", soak_minutes, "random faults for so long, instead");
  bool list = false;
  app.add_flag("--list", list, "names the scenarios");
  if (const auto code = process::parse_command_line(app, argc, argv)) return *code;
  if (list) {
    for (const Scenario& one : all_scenarios()) {
      std::printf("%-14s %s\n", std::string(one.name).c_str(), std::string(one.what).c_str());
    }
    return process::kDone;
  }
  if (const std::string problem = Hosts::problem(); !problem.empty()) {
    throw std::runtime_error("no hosts can be made here: " + problem);
  }
  go_first();
  if (soak_minutes > 0.0) {
    return show(soak(options, soak_minutes)) ? process::kDone : process::kAnswerIsNo;
  }
  return run_scenarios(names, options);
}

}  // namespace
}  // namespace teamsight::network

int main(int argc, char** argv) {
  return teamsight::process::run_program("teamsight-bench-hosts",
                                         [&] { return teamsight::network::run(argc, argv); });
}
