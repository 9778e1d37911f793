// fusion/track.hpp: an obstacle that several robots see, and the list of all of them.
#pragma once

#include "fusion/considered.hpp"
#include "fusion/track_book.hpp"

namespace teamsight::fusion {

/// An obstacle: (x, y, vx, vy) in F; m, m/s.
struct Track {
  TrackBook book;
  Considered<4> state;
  double radius{0.0};  ///< m
};

inline constexpr std::size_t kMaxTracks = 24;
using TrackList = InlineList<Track, kMaxTracks>;

/// Takes all obstacles that one frame shows into the tracks, see fusion/turn.hpp.
///
/// @return how many candidates fitted no track and were not used to begin one
std::uint32_t take_in(TrackList& tracks,
                      const CandidateList& candidates,
                      const Scene& scene,
                      const TrackParameters& parameters);

/// Where the track is at `now`; at its own time if that is later.
[[nodiscard]] PlanarMoments moments_at(const Track& track,
                                       HostTime now,
                                       const TrackParameters& parameters);

/// Wider or narrower by the factor (at least 1) by which an observation lies outside of what its
/// covariance promises: errors have heavy tails [Agamennoni12].
///
/// @param squared_distance  Mahalanobis, under the covariance of the gap
[[nodiscard]] double tail_factor(double squared_distance, int degrees);

/// Density of an observation of two coordinates that lies so far outside, with tails like that.
///
/// @param inverse_cov  of the gap's covariance
[[nodiscard]] double tail_density(double squared_distance, const Eigen::Matrix2d& inverse_cov);

}  // namespace teamsight::fusion
