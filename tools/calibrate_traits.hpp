// tools/calibrate_traits.hpp: `teamsight calibrate balls` and `robots`: what they look like.
#pragma once

#include <CLI/App.hpp>

namespace teamsight::tools {

/// Adds `calibrate balls` and `calibrate robots`: one JSON line with the weights for
/// vision/ball_model.cpp and obstacle_model.cpp. Exit code 0, 2 on bad input.
void add_calibrate_traits(CLI::App& calibrate, int& exit_code);

}  // namespace teamsight::tools
