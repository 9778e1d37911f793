// fusion/ball_hint.hpp: the operator's word about which of the balls that are seen is the game's.
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "fusion/ball_track.hpp"
#include "fusion/parameters.hpp"
#include "geometry/frames.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// "The ball is there": said once, about what the robots see, never instead of it.
struct BallHint {
  std::uint32_t number{0};  ///< tells hints apart, never 0; the same hint said twice is one
  HostTime given;           ///< when it came to this host
  Point<Field> p_FB;        ///< where the operator saw the ball; m
  Eigen::Matrix2d cov{Eigen::Matrix2d::Identity()};  ///< of p_FB; m^2

  friend bool operator==(const BallHint&, const BallHint&) = default;
};

/// Which ball the newest hint means: a part of what fusion believes.
struct HintedBall {
  std::uint32_t hint{0};  ///< BallHint::number; 0: none
  std::uint32_t key{0};   ///< of the track; 0: no ball near the hint
  HostTime given;
};

/// Looks for the ball that a hint means, after one frame has been taken in.
///
/// The confirmed track that fits the hint best, if any lies within its gate, becomes the one that
/// is meant and stays so wherever it rolls, until another hint comes. Changes no track.
///
/// @param exposure  of that frame; one before the hint or after its time changes nothing
void heed(HintedBall& hinted,
          const BallHint& hint,
          const BallList& balls,
          HostTime exposure,
          const HintParameters& parameters);

/// How many robots that watch the ball the hint outweighs for this track at `now`; 0: none.
[[nodiscard]] double weight_of(const HintedBall& hinted,
                               std::uint32_t key,
                               HostTime now,
                               const HintParameters& parameters);

/// For how long the hint still counts.
[[nodiscard]] Duration time_left(HostTime given, HostTime now, const HintParameters& parameters);

}  // namespace teamsight::fusion
