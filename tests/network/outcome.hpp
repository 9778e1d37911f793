// tests/network/outcome.hpp: what a scenario found, as lines to read and claims that must hold.
#pragma once

#include <string>
#include <vector>

namespace teamsight::network {

/// One scenario's result. `lines` are figures for people; `broken` are claims that did not hold.
struct Outcome {
  std::string scenario;
  std::vector<std::string> lines;
  std::vector<std::string> broken;

  void say(std::string line) { lines.push_back(std::move(line)); }

  void expect(bool holds, std::string claim) {
    if (!holds) broken.push_back(std::move(claim));
  }
};

}  // namespace teamsight::network
