// fusion/sight.hpp: how well a frame's observer sees, from what the state knows, and what its frame
// teaches about that.
#pragma once

#include "fusion/sighted.hpp"
#include "fusion/state.hpp"

namespace teamsight::fusion {

/// What is known of the observer's eyes, and of the bodies in its way.
[[nodiscard]] Sight sight_of(const State& state,
                             const Teammate& observer,
                             const Glance& glance,
                             const Parameters& parameters);

/// Learns how completely the observer reports, from the teammates and obstacles of which others
/// know where they are.
///
/// @param mates  which of the frame's obstacles are teammates
/// @pre the frame has been taken into the tracks
void learn_eyesight(State& state,
                    Teammate& observer,
                    const MateSightings& mates,
                    const Scene& scene,
                    const Parameters& parameters);

}  // namespace teamsight::fusion
