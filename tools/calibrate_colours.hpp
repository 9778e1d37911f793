// tools/calibrate_colours.hpp: `teamsight calibrate colours`.
#pragma once

namespace CLI {
class App;
}

namespace teamsight::tools {

/// Adds `colours` to `teamsight calibrate`.
void add_calibrate_colours(CLI::App& calibrate, int& exit_code);

}  // namespace teamsight::tools
