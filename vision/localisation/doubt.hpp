// vision/localisation/doubt.hpp: the numbers by which the localisation believes and doubts itself.
#pragma once

#include "geometry/time.hpp"

namespace teamsight::vision {

/// Votes per point below which a posture is not believed, without and with a history.
inline constexpr double kLostSupport = 0.45;
inline constexpr double kSomeSupport = 0.4;
inline constexpr double kLeastSupport = 0.3;
/// What stands for the usual votes per point of a place that somebody named.
inline constexpr double kNamedSupport = 1.2;
/// Of the usual votes per point: less than this is a miss; less than that calls for a search.
inline constexpr double kKeptSupport = 0.6;
inline constexpr double kDoubtedSupport = 0.8;

/// Log-likelihood of losing all votes: a posture with 92 % of the best one's is two behind.
inline constexpr double kVoteEvidence = 25.0;

/// A doubt that lasts this long is told.
inline constexpr Duration kDoubtTold = std::chrono::milliseconds(120);

inline constexpr double kSureShare = 0.9;  ///< of the best hypothesis among all
inline constexpr double kSureHalf = 2.2;   ///< log-odds: nine to one
inline constexpr double kOkSigma = 0.3;    ///< m; more is not ok
inline constexpr double kLostSigma = 1.5;  ///< m; more is lost
inline constexpr double kFastest = 4.0;    ///< m/s, of a robot pushed or slipping
inline constexpr double kNearReach = 0.3;  ///< m; a robot may always have been pushed that far

}  // namespace teamsight::vision
