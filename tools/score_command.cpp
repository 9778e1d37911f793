// tools/score_command.cpp: see tools/score_command.hpp.
#include "tools/score_command.hpp"

#include <CLI/CLI.hpp>

#include "tools/score_patterned_command.hpp"

namespace teamsight::tools {

void add_score_command(CLI::App& app, int& exit_code) {
  CLI::App* score = app.add_subcommand("score", "accuracy against truth, beside bounds and peers");
  score->require_subcommand(1);
  add_score_calibrate_command(*score, exit_code);
  add_score_detect_command(*score, exit_code);
  add_score_locate_command(*score, exit_code);
  add_score_fuse_command(*score, exit_code);
  add_score_patterned_command(*score, exit_code);
  add_score_rendered_command(*score, exit_code);
  add_score_shirts_command(*score, exit_code);
  add_score_mrclam_command(*score, exit_code);
  add_score_refbox_game_command(*score, exit_code);
}

}  // namespace teamsight::tools
