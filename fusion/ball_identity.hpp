// fusion/ball_identity.hpp: which ball of now is which ball of before.
#pragma once

#include <cstdint>

#include "fusion/ball_track.hpp"

namespace teamsight::fusion {

/// Keys of the confirmed tracks.
using BallKeys = InlineList<std::uint32_t, kMaxBallTracks>;
[[nodiscard]] BallKeys confirmed_keys(const BallList& balls);

/// Lets a ball that is found again be the one that it was, after one frame has been taken in.
///
/// A ball that nobody has seen for a while may be nearly anywhere, and what is seen then begins a
/// track of its own (whatever is seen fits a track that may be anywhere, the false as well). Once
/// that track is confirmed, and within its first second, it takes the key of the lost one, which
/// ends: of the one that it clearly goes on from (fusion/ball_choice.hpp), or, if no other ball is
/// known, of the one that was given up last. A ball that began where one that was still seen may
/// have been kicked is marked as its branch.
///
/// @param before  the tracks that were confirmed before the frame
/// @param lost  key of the track that was given up last and not found again; 0: none
/// @return the same as of now
[[nodiscard]] std::uint32_t recognise(BallList& balls,
                                      const BallKeys& before,
                                      std::uint32_t lost,
                                      const Parameters& parameters);

}  // namespace teamsight::fusion
