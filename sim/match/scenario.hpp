// sim/match/scenario.hpp: matches by name, for tests and scores.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "geometry/field_model.hpp"
#include "sim/match/match.hpp"

namespace teamsight::sim {

/// What a scenario is good for, beside its name.
struct ScenarioName {
  std::string_view name;
  std::string_view purpose;
};

/// All scenarios that make_scenario knows.
[[nodiscard]] std::span<const ScenarioName> scenario_names();

/// A match of five against five that shows one kind of event again and again. It goes on for ever;
/// scripted events happen in the first minute.
///
/// @param seed  draws the places, the decisions and the scripted events
/// @return nothing if there is no scenario of that name
[[nodiscard]] std::optional<MatchParameters> make_scenario(std::string_view name,
                                                           std::uint32_t seed,
                                                           const FieldModel& field);

/// The same for other teams and bodies: `base` without script, with its own seed.
[[nodiscard]] std::optional<MatchParameters> make_scenario(std::string_view name,
                                                           MatchParameters base,
                                                           const FieldModel& field);

}  // namespace teamsight::sim
