// fusion/ball_hint.cpp: see fusion/ball_hint.hpp.
#include "fusion/ball_hint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/uncertainty.hpp"

namespace teamsight::fusion {
namespace {

struct Fit {
  double distance{0.0};  ///< squared, in standard deviations
  double cost{0.0};  ///< -2 log likelihood, up to a constant: one that may be anywhere fits less
};

Fit fit_of(const BallTrack& ball, const BallHint& hint, const HintParameters& parameters) {
  const BallMoments moments = moments_of(ball.beliefs);
  const Eigen::Vector2d gap_F = moments.mean.head<2>() - hint.p_FB.vector();
  const Eigen::Vector2d rolled_F = to_seconds(parameters.reaction) * moments.mean.segment<2>(3);
  const Eigen::Matrix2d cov =
      moments.cov.topLeftCorner<2, 2>() + hint.cov + rolled_F * rolled_F.transpose();
  const double distance = squared_mahalanobis(gap_F, cov);
  return {distance, distance + std::log(cov.determinant())};
}

}  // namespace

void heed(HintedBall& hinted,
          const BallHint& hint,
          const BallList& balls,
          HostTime exposure,
          const HintParameters& parameters) {
  if (exposure < hint.given) return;
  if (hinted.hint != hint.number) hinted = {hint.number, 0, hint.given};
  if (hinted.key != 0 || time_left(hint.given, exposure, parameters) == Duration{0}) return;
  const double gate = chi_square_gate(2, parameters.gate_probability);
  double least = std::numeric_limits<double>::infinity();
  for (const BallTrack& ball : balls) {
    if (!ball.book.is_confirmed) continue;
    const Fit fit = fit_of(ball, hint, parameters);
    if (fit.distance > gate || fit.cost >= least) continue;
    least = fit.cost;
    hinted.key = ball.book.key;
  }
}

double weight_of(const HintedBall& hinted,
                 std::uint32_t key,
                 HostTime now,
                 const HintParameters& parameters) {
  if (hinted.key == 0 || hinted.key != key) return 0.0;
  const Duration left = time_left(hinted.given, now, parameters);
  return parameters.robots * to_seconds(left) / to_seconds(parameters.lasting);
}

Duration time_left(HostTime given, HostTime now, const HintParameters& parameters) {
  return std::clamp(given + parameters.lasting - now, Duration{0}, parameters.lasting);
}

}  // namespace teamsight::fusion
