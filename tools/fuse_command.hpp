// tools/fuse_command.hpp: `teamsight fuse`.
#pragma once

namespace CLI {
class App;
}

namespace teamsight::tools {

/// Adds `fuse`: fusion over the Sightings of a recording, bit for bit the same each time.
void add_fuse_command(CLI::App& app, int& exit_code);

}  // namespace teamsight::tools
