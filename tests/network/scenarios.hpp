// tests/network/scenarios.hpp: the faults, one function each: set up, break, look, compare.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/network/outcome.hpp"

namespace teamsight::network {

/// What the caller chooses.
struct ScenarioOptions {
  std::string profile{"wifi"};
  std::uint64_t seed{1};
  double length{1.0};           ///< of the observed time, as a factor
  std::string more_team_lines;  ///< added to the team file
};

struct Scenario {
  std::string_view name;
  std::string_view what;
  Outcome (*run)(const ScenarioOptions&);
};

/// For GoogleTest, which would print the bytes, pointers and all.
// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest's name
inline void PrintTo(const Scenario& scenario, std::ostream* out) {
  *out << scenario.name;
}

[[nodiscard]] const std::vector<Scenario>& all_scenarios();

/// Of scenarios_security.cpp.
[[nodiscard]] Outcome security(const ScenarioOptions& options);
[[nodiscard]] Outcome attack_off(const ScenarioOptions& options);
[[nodiscard]] Outcome attack_on(const ScenarioOptions& options);

/// Of scenarios_twin.cpp.
[[nodiscard]] Outcome twin(const ScenarioOptions& options);

/// Random faults, one after the other; then the team must be whole, and no process have grown.
[[nodiscard]] Outcome soak(const ScenarioOptions& options, double minutes);

}  // namespace teamsight::network
