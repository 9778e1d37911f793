// tools/teamsight.cpp: the `teamsight` command; each subcommand lives in <name>_command.cpp.

#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>

#include "tools/mirror_command.hpp"

namespace {

constexpr int kBadInput = 2;

/// Adds every subcommand. Each one stores what it returns to the shell in `exit_code`.
void add_commands(CLI::App& app, int& exit_code) {
  // One line per command, in alphabetical order.
  teamsight::tools::add_mirror_command(app, exit_code);
}

/// Help and version go to stdout; a usage error is one line on stderr.
int report(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    return app.exit(error);
  }
  std::cerr << "teamsight: " << error.what() << " (teamsight --help lists what there is)\n";
  return kBadInput;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Looks at the team's shared picture of the game, and at what it is made from.",
               "teamsight"};
  app.require_subcommand(1);
  app.set_version_flag("--version", TEAMSIGHT_VERSION);
  int exit_code = 0;
  try {
    add_commands(app, exit_code);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report(app, error);
  } catch (const std::exception& error) {
    std::cerr << "teamsight: " << error.what() << '\n';
    return kBadInput;
  }
  return exit_code;
}
