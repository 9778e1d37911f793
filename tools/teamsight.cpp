// tools/teamsight.cpp: the `teamsight` command; each subcommand lives in <name>_command.cpp.

#include <CLI/CLI.hpp>

#include "process/program.hpp"
#include "tools/calibrate_command.hpp"
#include "tools/detect_command.hpp"
#include "tools/doctor_command.hpp"
#include "tools/echo_command.hpp"
#include "tools/fuse_command.hpp"
#include "tools/keys_command.hpp"
#include "tools/locate_command.hpp"
#include "tools/log_command.hpp"
#include "tools/mirror_command.hpp"
#include "tools/score_command.hpp"

namespace {

/// Adds every subcommand, in alphabetical order. Each one stores what the shell gets in
/// `exit_code`.
void add_commands(CLI::App& app, int& exit_code) {
  teamsight::tools::add_calibrate_command(app, exit_code);
  teamsight::tools::add_detect_command(app, exit_code);
  teamsight::tools::add_doctor_command(app, exit_code);
  teamsight::tools::add_echo_command(app, exit_code);
  teamsight::tools::add_fuse_command(app, exit_code);
  teamsight::tools::add_keys_command(app, exit_code);
  teamsight::tools::add_locate_command(app, exit_code);
  teamsight::tools::add_log_command(app, exit_code);
  teamsight::tools::add_mirror_command(app, exit_code);
  teamsight::tools::add_score_command(app, exit_code);
}

int run(int argc, char** argv) {
  CLI::App app{"Looks at the team's shared picture of the game, and at what it is made from.",
               "teamsight"};
  app.require_subcommand(1);
  app.set_version_flag("--version", TEAMSIGHT_VERSION);
  int exit_code = teamsight::process::kDone;
  add_commands(app, exit_code);
  if (const auto done = teamsight::process::parse_command_line(app, argc, argv)) return *done;
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  return teamsight::process::run_program("teamsight", [&]() { return run(argc, argv); });
}
