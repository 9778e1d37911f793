// process/program.hpp: what the main() of every Teamsight program has in common.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace CLI {
class App;
}

namespace teamsight::process {

/// Exit codes of every program.
inline constexpr int kDone = 0;
inline constexpr int kAnswerIsNo = 1;
inline constexpr int kBadInput = 2;

/// Runs a program's body and turns whatever it throws into one line on stderr.
///
/// `int main(int argc, char** argv) { return run_program("teamsight-x", [&] { ... return kDone; });
/// }`
///
/// @param name  stands at the start of the line
/// @param body  returns the exit code; what it throws names file, key, what was found and what
///              was expected
/// @return what `body` returned, or kBadInput if it threw
[[nodiscard]] int run_program(const char* name, const std::function<int()>& body) noexcept;

/// Parses the command line; the only way our programs call CLI11.
///
/// @return nothing if the program should go on; kDone after it printed help or version
/// @throws std::runtime_error with one line for a wrong command line
[[nodiscard]] std::optional<int> parse_command_line(CLI::App& app,
                                                    int argc,
                                                    const char* const* argv);

/// A number that tells this start of the program from every other: random, never 0.
[[nodiscard]] std::uint32_t draw_boot_id();

}  // namespace teamsight::process
