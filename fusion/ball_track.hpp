// fusion/ball_track.hpp: a ball that several robots see, and what may have become of it.
#pragma once

#include <limits>
#include <vector>

#include "fusion/ball_beliefs.hpp"
#include "fusion/ball_view.hpp"
#include "fusion/kick_habits.hpp"
#include "fusion/track_book.hpp"

namespace teamsight::fusion {

struct BallTrack {
  TrackBook book;
  BallBeliefs beliefs;
  double since_split{0.0};  ///< s: since kicks were last thought of
  double kick_rate{0.0};    ///< kicks per second that were then to be expected
  double high_share{0.0};   ///< ... and the share of those into the air
  /// s: since the last kick that was counted.
  double since_counted{std::numeric_limits<double>::infinity()};
  /// Key of the ball that was seen beside it when it began, and that it may be instead; 0: none.
  std::uint32_t branched_from{0};
  bool is_known_again{false};  ///< it goes under the id of a ball that was lost
  /// Key of the ball that it best goes on from, by what was known when it was young; 0: none.
  std::uint32_t goes_on_from{0};
  double log_going_on{0.0};  ///< ... and how well, see log_explained
};

inline constexpr std::size_t kMaxBallTracks = 6;
using BallList = InlineList<BallTrack, kMaxBallTracks>;

/// How balls move and are tracked.
struct BallSetting {
  BallMotion motion;
  TrackParameters track;
};

/// The rays of a frame that may be balls.
struct BallSightings {
  const CandidateList& candidates;  ///< where they meet the floor; `index` says which ray it is
  const std::vector<BallRay>& rays;
  const Kickers& kickers;  ///< who may kick it
  KickTally& kicks;        ///< those that became clear by the frame are added
};

/// Takes all ball rays that one frame shows into the tracks, see fusion/turn.hpp. A bank of
/// possibilities (fusion/ball_beliefs.hpp) over raw rays, so that two robots triangulate a flying
/// ball.
///
/// @return how many candidates fitted no track and were not used to begin one
std::uint32_t take_in(BallList& tracks,
                      const BallSightings& sightings,
                      const Scene& scene,
                      const BallSetting& setting);

/// Where the ball is at `now`; at the track's own time if that is later.
[[nodiscard]] BallMoments moments_at(const BallTrack& track,
                                     HostTime now,
                                     const BallMotion& all_games);

}  // namespace teamsight::fusion
