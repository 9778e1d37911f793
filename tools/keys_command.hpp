// tools/keys_command.hpp: `teamsight keys`: who may speak for the team.
#pragma once

namespace CLI {
class App;
}

namespace teamsight::tools {

/// Adds the subcommand.
void add_keys_command(CLI::App& app, int& exit_code);

}  // namespace teamsight::tools
