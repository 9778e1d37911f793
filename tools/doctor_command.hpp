// tools/doctor_command.hpp: `teamsight doctor`: is this robot ready, and if not, what to do.
#pragma once

namespace CLI {
class App;
}

namespace teamsight::tools {

/// Adds the subcommand. Exit code 1 if anything is wrong.
void add_doctor_command(CLI::App& app, int& exit_code);

}  // namespace teamsight::tools
