// tools/mirror_command.hpp: `teamsight mirror`: designs mirrors and says what they see.
#pragma once

// The library's own name.
// NOLINTNEXTLINE(readability-identifier-naming)
namespace CLI {
class App;
}

namespace teamsight::tools {

/// Adds `mirror design` and `mirror trace`.
///
/// @param exit_code  becomes 0 when done, 1 if a design does not close or a pixel lies beside the
///                   mirror; bad input is thrown as an exception with one line
void add_mirror_command(CLI::App& app, int& exit_code);

}  // namespace teamsight::tools
