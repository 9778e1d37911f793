// tools/score_command.hpp: `teamsight score`: accuracy against truth, beside bounds and peers.
#pragma once

#include <CLI/App.hpp>

namespace teamsight::tools {

/// Adds `score` with a subcommand for each thing that can be scored.
void add_score_command(CLI::App& app, int& exit_code);

/// Adds `score calibrate`: one JSON line per robot with a bent mirror, and one for all. Exit code 1
/// if a robot's floor stays off by more than wanted, 2 on bad input.
void add_score_calibrate_command(CLI::App& score, int& exit_code);

/// Adds `score detect`: one JSON line per series, per team and for all. Exit code 0, 2 on bad
/// input.
void add_score_detect_command(CLI::App& score, int& exit_code);

/// Adds `score locate`: one JSON line per case and method on stdout, tables on stderr. Exit code 0,
/// 2 on bad input.
void add_score_locate_command(CLI::App& score, int& exit_code);

/// Adds `score rendered`: one JSON line per pixel format and light, without and with following it.
/// Exit code 0, 2 on bad input.
void add_score_rendered_command(CLI::App& score, int& exit_code);

/// Adds `score shirts`: one JSON line per pair of shirts, per range and for all. Exit code 0, 2 on
/// bad input.
void add_score_shirts_command(CLI::App& score, int& exit_code);

/// Adds `score fuse`: one JSON line per scenario and estimator. Exit code 0, 2 on bad input.
void add_score_fuse_command(CLI::App& score, int& exit_code);

/// Adds `score mrclam`: one JSON line per case and robot. Exit code 0, 2 on bad input.
void add_score_mrclam_command(CLI::App& score, int& exit_code);

/// Adds `score refbox-game`: one JSON line per team and estimator, over a game as the referee box
/// kept it. Exit code 0, 2 on bad input.
void add_score_refbox_game_command(CLI::App& score, int& exit_code);

}  // namespace teamsight::tools
