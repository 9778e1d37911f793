// tools/calibrate_lines.hpp: `teamsight calibrate lines`.
#pragma once

namespace CLI {
class App;
}

namespace teamsight::tools {

/// Adds `lines` to `teamsight calibrate`: images or line pixels from unknown places on a field.
void add_calibrate_lines(CLI::App& calibrate, int& exit_code);

}  // namespace teamsight::tools
