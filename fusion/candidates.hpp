// fusion/candidates.hpp: what one frame shows, in F: the candidates for tracks and teammates.
#pragma once

#include "fusion/observation.hpp"
#include "fusion/state.hpp"
#include "fusion/track_book.hpp"

namespace teamsight::fusion {

/// Everything one frame shows.
struct Sighted {
  CandidateList balls;
  CandidateList obstacles;
};

/// A ball whose ray does not meet the carpet, or where nobody could say, is in the air where its
/// size says; where that says too little, it may be a flying ball's and begins no track.
///
/// @param errors  with this frame's posture reported already
[[nodiscard]] Sighted sighted_in(const Observation& observation,
                                 const TeamErrors& errors,
                                 const Setting& setting);

}  // namespace teamsight::fusion
