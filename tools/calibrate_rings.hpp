// tools/calibrate_rings.hpp: `teamsight calibrate rings`.
#pragma once

namespace CLI {
class App;
}

namespace teamsight::tools {

/// Adds `rings` to `teamsight calibrate`: a picture of marks at known distances.
void add_calibrate_rings(CLI::App& calibrate, int& exit_code);

}  // namespace teamsight::tools
