// tests/client/consumer/main.cpp: a behaviour program of a few lines, built against the installed
// library.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "client/team_world.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    teamsight::TeamWorldOptions options;
    options.team_domain = static_cast<unsigned>(std::atoi(argv[2]));
    teamsight::TeamWorld team(argv[1], options);
    const teamsight::World world = team.freshest();
    std::printf("source %d balls %zu game %s\n",
                static_cast<int>(world.source),
                world.model.balls.size(),
                team.game() ? "known" : "unknown");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
