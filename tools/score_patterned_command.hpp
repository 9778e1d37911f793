// tools/score_patterned_command.hpp: patterned balls in rendered scenes: how many, and the weights.
#pragma once

#include <CLI/App.hpp>

namespace teamsight::tools {

/// Adds `score patterned`: one JSON line per ball and distance, and one per ball with what was
/// invented. Exit code 0, 2 on bad input.
void add_score_patterned_command(CLI::App& score, int& exit_code);

/// Adds `calibrate patterned`: one JSON line with the weights for vision/pattern_traits.cpp. Exit
/// code 0, 2 on bad input.
void add_calibrate_patterned(CLI::App& calibrate, int& exit_code);

}  // namespace teamsight::tools
