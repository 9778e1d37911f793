// tools/detect_command.hpp: `teamsight detect`: balls, obstacles and free space in an image.
#pragma once

#include <CLI/App.hpp>

namespace teamsight::tools {

/// Adds `detect`: one JSON line per image. Exit code 0, 2 on bad input.
void add_detect_command(CLI::App& app, int& exit_code);

}  // namespace teamsight::tools
