// tools/locate_command.hpp: `teamsight locate`: where the robot stood that took an image.
#pragma once

#include <CLI/App.hpp>

namespace teamsight::tools {

/// Adds `locate`: one JSON line per image. Exit code 0, 1 if an image is lost, 2 on bad input.
void add_locate_command(CLI::App& app, int& exit_code);

}  // namespace teamsight::tools
