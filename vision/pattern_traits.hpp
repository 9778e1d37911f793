// vision/pattern_traits.hpp: what tells a patterned ball from other things of its colours.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "vision/trait_model.hpp"

namespace teamsight::vision {

/// In the order of PatternTraits.
inline constexpr std::array<std::string_view, 8> kPatternTraitNames{
    "too_small",  // square of the logarithm of its radius over a ball's on the floor there
    "too_large",  // the same where it is larger: it may be in the air
    "scatter",    // of the carpet's edge about a disc, over its radius
    "carpet",     // share of the directions in which carpet begins at the disc's edge
    "front",      // the same of those towards the robot, where it stands on the carpet
    "foreign",    // share of the disc that is no colour of the ball
    "mixture",    // share of its second colour, at most kMostMixture
    "between",    // share between its white and black
};

inline constexpr std::size_t kPatternTraits = kPatternTraitNames.size();
inline constexpr double kMostMixture = 0.25;
using PatternTraits = std::array<double, kPatternTraits>;
using PatternModel = TraitModel<kPatternTraits>;

/// How probably something is a ball at most, whatever its colours are.
///
/// @param traits  of which those of its colours (the last three) do not count
[[nodiscard]] double most_probable(const PatternModel& model, PatternTraits traits);

/// What `teamsight calibrate patterned` made of rendered scenes; see vision/README.md for how well
/// it does on others.
[[nodiscard]] PatternModel trained_pattern_model();

}  // namespace teamsight::vision
