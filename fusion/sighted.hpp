// fusion/sighted.hpp: which of the things that one frame shows are teammates, and what that tells.
#pragma once

#include "fusion/candidates.hpp"
#include "fusion/observation.hpp"
#include "fusion/state.hpp"
#include "fusion/track_book.hpp"
#include "fusion/witness.hpp"

namespace teamsight::fusion {

/// Which candidate is which teammate, by index; kUnassigned where it is none.
struct MateSightings {
  std::array<int, kMaxCandidates> mate_of{};
  /// Which teammate it touches, though it is rather another body beside it. If many do, the
  /// teammate stands aside of where it says.
  std::array<int, kMaxCandidates> beside{};
};

/// Gives sighted things to teammates at the least total cost: within the gate, or so near to a
/// teammate that it is likelier the teammate, badly seen, than another body that stands beside it.
[[nodiscard]] MateSightings find_teammates(const CandidateList& candidates,
                                           const State& state,
                                           const Observation& observation,
                                           const Parameters& parameters);

/// Learns of both robots' errors from each sighting of a teammate, the less the likelier it is that
/// another body stands there and the teammate is hidden.
void learn_from_teammates(State& state,
                          const CandidateList& candidates,
                          const MateSightings& mates,
                          const Glance& glance,
                          const Parameters& parameters);

/// What other robots than this one say is there.
[[nodiscard]] ClaimList claims_of_others(const State& state,
                                         RobotId robot,
                                         HostTime exposure,
                                         const Parameters& parameters);

}  // namespace teamsight::fusion
