// fusion/obstacle_identity.hpp: an obstacle that was lost and is found again keeps its id.
#pragma once

#include <cstdint>

#include "fusion/parameters.hpp"
#include "fusion/track.hpp"

namespace teamsight::fusion {

/// A confirmed obstacle as it was last.
struct KnownObstacle {
  std::uint32_t key{0};
  HostTime last_hit{kNever};
  HostTime time{kNever};  ///< what `moments` are of
  double proven{0.0};     ///< see TrackBook
  PlanarMoments moments;
};

using KnownObstacles = InlineList<KnownObstacle, kMaxTracks>;

/// The confirmed tracks.
[[nodiscard]] KnownObstacles known_obstacles(const TrackList& tracks);

/// Follows who was lost and who is found. A track that has just been confirmed takes the key of a
/// lost one that was seen last before it began, if it is likelier to be that one, as that may have
/// moved since, than one more that nobody has seen. If more than one robot had vouched for that, it
/// is no newcomer and not to be doubted. What was never believed is not remembered.
///
/// @param before    known_obstacles before this frame
/// @param lost      those that were dropped, for as long as they are remembered
/// @param exposure  of this frame
void recognise(TrackList& tracks,
               const KnownObstacles& before,
               KnownObstacles& lost,
               HostTime exposure,
               const Parameters& parameters);

}  // namespace teamsight::fusion
