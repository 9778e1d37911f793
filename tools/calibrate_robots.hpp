// tools/calibrate_robots.hpp: `teamsight calibrate robots`: what robots look like, from labels.
#pragma once

#include <CLI/App.hpp>

namespace teamsight::tools {

/// Adds `calibrate robots`: one JSON line with the weights for vision/obstacle_model.cpp. Exit code
/// 0, 2 on bad input.
void add_calibrate_robots(CLI::App& calibrate, int& exit_code);

}  // namespace teamsight::tools
