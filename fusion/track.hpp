// fusion/track.hpp: one thing on the field that several robots see, and the list of all of a kind.
#pragma once

#include <array>
#include <cstdint>

#include "fusion/inline_list.hpp"
#include "fusion/parameters.hpp"
#include "fusion/planar_filter.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// Earlier than every exposure: it has never happened.
inline constexpr HostTime kNever{std::chrono::hours(-1)};

/// A moment per robot, kNever at first; index is robot id - 1.
using RobotTimes = std::array<HostTime, kMaxRobotId>;

[[nodiscard]] constexpr RobotTimes no_robot_times() {
  RobotTimes times{};
  for (auto& time : times) time = kNever;
  return times;
}

/// A ball or an obstacle.
struct Track {
  std::uint32_t key{0};  ///< made from the observation that began it: the same in every instance
  PlanarFilter filter;
  HostTime time{kNever};      ///< what the filter is predicted to
  HostTime born{kNever};      ///< exposure of its first observation
  HostTime last_hit{kNever};  ///< exposure of its last observation
  double log_odds{0.0};       ///< of existence
  double radius{0.0};         ///< m
  std::uint32_t hits{0};
  bool is_confirmed{false};
  double nis_sum{0.0};  ///< normalised innovations squared, 2 degrees of freedom each
  RobotTimes supported{no_robot_times()};  ///< last observation in it
  RobotTimes rejected{no_robot_times()};   ///< last time the robot saw only others of the kind
};

inline constexpr std::size_t kMaxTracks = 24;
using TrackList = InlineList<Track, kMaxTracks>;

/// One thing that one frame shows, in F.
struct Candidate {
  PlanarMeasurement measurement;
  double confidence{0.0};
  double radius{0.0};      ///< m
  double azimuth{0.0};     ///< from the observer, in F; rad
  double distance{0.0};    ///< from the observer; m
  double half_angle{0.0};  ///< it hides what is behind it within this angle; rad
  std::uint32_t key{0};    ///< of the track that it would begin
};

inline constexpr std::size_t kMaxCandidates = 16;
using CandidateList = InlineList<Candidate, kMaxCandidates>;

/// Who looks, from where and when.
struct Glance {
  RobotId robot{kNobody};
  HostTime exposure{kNever};
  Duration sigma_exposure{0};
  Eigen::Vector2d p_FR{Eigen::Vector2d::Zero()};  ///< of the observer; m
};

/// Takes everything of one kind that one frame shows into the tracks of that kind.
///
/// Predicts the tracks to the exposure, assigns candidates to tracks (global nearest neighbour
/// within the gate), updates, counts misses where the observer should have seen something and
/// nothing nearer hides it, begins, confirms, merges and drops tracks.
///
/// @param hiding  everything the frame shows that may hide a track, of whatever kind
/// @return how many candidates fitted no track and were not used to begin one
std::uint32_t take_in(TrackList& tracks,
                      const CandidateList& candidates,
                      const Glance& glance,
                      const CandidateList& hiding,
                      const TrackParameters& parameters);

/// Where the track is at `now`; at its own time if that is later.
[[nodiscard]] PlanarMoments moments_at(const Track& track,
                                       HostTime now,
                                       const TrackParameters& parameters);

/// Probability that the track's thing is there at `now`.
[[nodiscard]] double existence_at(const Track& track,
                                  HostTime now,
                                  const TrackParameters& parameters);

/// Robots whose time lies within `window` before `now`.
[[nodiscard]] RobotMask robots_within(const RobotTimes& times, HostTime now, Duration window);

/// A number for a track that every instance derives alike from the observation that began it.
///
/// @param index  of the candidate in its observation, different for balls and obstacles
/// @return never 0
[[nodiscard]] std::uint32_t track_key(const ObservationId& id, std::uint32_t index);

}  // namespace teamsight::fusion
