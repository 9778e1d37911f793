// fusion/ball_choice.hpp: which of the balls that are seen is the game's.
#pragma once

#include <cstddef>

#include "fusion/ball_hint.hpp"
#include "fusion/ball_track.hpp"
#include "fusion/parameters.hpp"

namespace teamsight::fusion {

/// Indices into a list of balls, each once.
using BallOrder = InlineList<std::size_t, kMaxBallTracks>;

/// Log-odds that a ball which turns up is real, before asking where it may have come from. One
/// robot's word is spent: the density of false balls counts those that one robot insists on.
[[nodiscard]] double log_odds_found(const BallTrack& ball, const Parameters& parameters);

/// Log of how much more often the ball `before` is found where, and as fast as, `after` is than a
/// false ball is.
///
/// Expected of a false ball: the same density everywhere, and no great speed. Expected of the ball:
/// what its possibilities say, of which a kick that nobody saw is one. A large negative number if
/// both were seen at the same time.
[[nodiscard]] double log_explained(const BallTrack& before,
                                   const BallTrack& after,
                                   const ChoiceParameters& parameters);

/// The same, whenever both were seen.
[[nodiscard]] double log_foreseen(const BallTrack& before,
                                  const BallTrack& after,
                                  const ChoiceParameters& parameters);

/// The confirmed balls: first the one that is the game's most probably.
///
/// The balls stand in the order of their births. Each younger one is weighed against the best of
/// the older: it is the game's ball if the older one was kicked there unseen, or was never one; it
/// is false, or another, if the older one still is where it is thought.
[[nodiscard]] BallOrder order_of_choice(const BallList& balls,
                                        const HintedBall& hinted,
                                        HostTime now,
                                        const Parameters& parameters);

}  // namespace teamsight::fusion
