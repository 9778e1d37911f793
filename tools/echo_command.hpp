// tools/echo_command.hpp: `teamsight echo TOPIC`: what is on the bus, now.
#pragma once

#include <CLI/CLI.hpp>

namespace teamsight::tools {

/// Adds `echo` to the command; `exit_code` becomes 0 if anything was heard, 1 if not.
void add_echo_command(CLI::App& app, int& exit_code);

}  // namespace teamsight::tools
