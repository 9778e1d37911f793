// fusion/ball_beliefs.hpp: what may have become of a ball, each possibility with its probability.
#pragma once

#include <limits>

#include "fusion/ball_motion.hpp"
#include "fusion/considered.hpp"
#include "fusion/feet.hpp"
#include "fusion/inline_list.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// The ball if one thing happened.
struct BallBelief {
  Considered<6> state;
  BallMode mode{BallMode::kRolling};
  double probability{0.0};
  RobotId seen_by{kNobody};               ///< whose ray it was that last told of it
  HostTime seen{std::chrono::hours(-1)};  ///< when; at first before every exposure
  /// s: since it was kicked; infinite: not since it is known.
  double since_kick{std::numeric_limits<double>::infinity()};
  BallMode kicked_into{BallMode::kRolling};  ///< ... and how
};

inline constexpr std::size_t kMaxBallBeliefs = 18;

/// Probabilities add up to 1. A kick begins a possibility of its own and leaves the others as sharp
/// as they are: mixed into them, as interacting models [Blom88] do, the chance of a kick in every
/// frame would keep the velocity of a ball that just rolls as uncertain as 0.8 m/s.
using BallBeliefs = InlineList<BallBelief, kMaxBallBeliefs>;

/// Mean and covariance over all possibilities.
struct BallMoments {
  BallVector mean{BallVector::Zero()};
  BallMatrix cov{BallMatrix::Identity()};
};

/// On the floor: height and climb are known, whatever was thought before.
void lay_down(Considered<6>& state, const BallMotion& motion);

/// Goes on in time. @param dt  s, above 0
void advance(BallBeliefs& beliefs, double dt, const BallMotion& motion);

/// Kicks per second to be expected of a ball, wherever it may be.
[[nodiscard]] double kick_rate(const BallBeliefs& beliefs,
                               const Kickers& kickers,
                               const BallMotion& motion);

/// Adds the possibilities that the ball was kicked within the last `dt` (s).
void split_off_kicks(BallBeliefs& beliefs,
                     double dt,
                     const Kickers& kickers,
                     const BallMotion& motion);

/// Adds others, their probabilities on the same scale: those that matter one by one, if there is
/// room or a less probable one; the rest of each way of moving as one, so that many of which none
/// matters are not forgotten together.
void add_others(BallBeliefs& beliefs, const BallBeliefs& others);

/// Makes one of possibilities that have become alike, forgets the improbable, normalises.
void tidy(BallBeliefs& beliefs);

[[nodiscard]] BallMoments moments_of(const BallBeliefs& beliefs);

/// Adds what a kick within the last `dt` (s), of which nothing is known, may have changed.
///
/// @param rate  kicks per second, see kick_rate
void doubt_kicks(BallMoments& moments, double dt, double rate, const BallMotion& motion);

}  // namespace teamsight::fusion
