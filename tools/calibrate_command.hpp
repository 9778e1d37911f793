// tools/calibrate_command.hpp: `teamsight calibrate`: camera files from pictures of known things.
#pragma once

#include <CLI/App.hpp>

namespace teamsight::tools {

/// Adds `calibrate rings`: a radial table from pictures of rings at known distances. One JSON line;
/// exit code 0, 1 if the rings were not found, 2 on bad input.
void add_calibrate_command(CLI::App& app, int& exit_code);

}  // namespace teamsight::tools
