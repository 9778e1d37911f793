// tools/calibrate_mask.hpp: `teamsight calibrate mask`.
#pragma once

namespace CLI {
class App;
}

namespace teamsight::tools {

/// Adds `mask` to `teamsight calibrate`.
void add_calibrate_mask(CLI::App& calibrate, int& exit_code);

}  // namespace teamsight::tools
