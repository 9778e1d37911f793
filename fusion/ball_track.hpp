// fusion/ball_track.hpp: a ball that several robots see: interacting models of how it moves.
#pragma once

#include <array>
#include <vector>

#include "fusion/ball_motion.hpp"
#include "fusion/ball_view.hpp"
#include "fusion/considered.hpp"
#include "fusion/track_book.hpp"

namespace teamsight::fusion {

/// The ball if it moved in one of the ways.
struct BallBelief {
  Considered<6> state;
  double probability{0.0};
};

struct BallTrack {
  TrackBook book;
  std::array<BallBelief, kBallModes> beliefs;  ///< index: BallMode
};

inline constexpr std::size_t kMaxBallTracks = 6;
using BallList = InlineList<BallTrack, kMaxBallTracks>;

/// Mean and covariance over all ways of moving.
struct BallMoments {
  BallVector mean{BallVector::Zero()};
  BallMatrix cov{BallMatrix::Identity()};
};

/// How balls move and are tracked.
struct BallSetting {
  BallMotion motion;
  TrackParameters track;
};

/// The rays of a frame that may be balls.
struct BallSightings {
  const CandidateList& candidates;  ///< where they meet the floor; `index` says which ray it is
  const std::vector<BallRay>& rays;
};

/// Takes all ball rays that one frame shows into the tracks, see fusion/turn.hpp. An interacting
/// multiple model filter [Blom88] over raw rays, so that two robots triangulate a flying ball.
///
/// @return how many candidates fitted no track and were not used to begin one
std::uint32_t take_in(BallList& tracks,
                      const BallSightings& sightings,
                      const Scene& scene,
                      const BallSetting& setting);

/// Where the ball is at `now`; at the track's own time if that is later.
[[nodiscard]] BallMoments moments_at(const BallTrack& track,
                                     HostTime now,
                                     const BallMotion& motion);

}  // namespace teamsight::fusion
