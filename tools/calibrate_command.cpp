// tools/calibrate_command.cpp: the ways to make a camera file, under one name.
#include "tools/calibrate_command.hpp"

#include <CLI/CLI.hpp>

#include "tools/calibrate_colours.hpp"
#include "tools/calibrate_lines.hpp"
#include "tools/calibrate_mask.hpp"
#include "tools/calibrate_rings.hpp"
#include "tools/calibrate_traits.hpp"
#include "tools/score_patterned_command.hpp"

namespace teamsight::tools {

void add_calibrate_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("calibrate", "Makes camera files from pictures");
  command->require_subcommand(1);
  add_calibrate_colours(*command, exit_code);
  add_calibrate_lines(*command, exit_code);
  add_calibrate_mask(*command, exit_code);
  add_calibrate_patterned(*command, exit_code);
  add_calibrate_rings(*command, exit_code);
  add_calibrate_traits(*command, exit_code);
}

}  // namespace teamsight::tools
