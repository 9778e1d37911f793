// tools/log_command.hpp: `teamsight log`: recordings of what was said on the bus.
#pragma once

namespace CLI {
class App;
}

namespace teamsight::tools {

/// Adds `log record`, `info`, `cut`, `convert` and `replay`.
void add_log_command(CLI::App& app, int& exit_code);

}  // namespace teamsight::tools
