// fusion/feet.cpp: see fusion/feet.hpp.
#include "fusion/feet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teamsight::fusion {
namespace {

/// That a normal variable is at most `beyond`.
double below(double beyond, double sigma) {
  return 0.5 * std::erfc(-beyond / (std::numbers::sqrt2 * sigma));
}

}  // namespace

Touch likeliest_touch(const BallPlace& ball, const FeetList& feet, double reach) {
  Touch touch;
  for (const Feet& foot : feet) {
    const Eigen::Vector2d way = ball.p_F - foot.p_F;
    const double distance = way.norm();
    const double var = ball.var + foot.var;
    const double sigma = std::sqrt(var);
    // The disc within which it is touched, as a square that is turned towards the ball: as far as
    // it must be known for a ball that may be metres away.
    const double side = foot.radius + reach;
    const double along = below(side - distance, sigma) - below(-side - distance, sigma);
    const double across = 1.0 - 2.0 * below(-side, sigma);
    const double probability = along * across;
    if (probability <= touch.probability) continue;
    // A way that is not longer than it is uncertain has no direction.
    touch = {probability, way / std::sqrt(distance * distance + var)};
  }
  return touch;
}

double unseen_touch(const BallPlace& ball, const Kickers& kickers, double reach) {
  if (kickers.unseen == nullptr) return 0.0;
  // The mean over four places around it.
  const double aside = std::sqrt(2.0 * ball.var);
  double share = 0.0;
  for (const double step : {-aside, aside}) {
    share += kickers.unseen->share_at(ball.p_F + Eigen::Vector2d(step, 0.0), kickers.carpet) +
             kickers.unseen->share_at(ball.p_F + Eigen::Vector2d(0.0, step), kickers.carpet);
  }
  const double side = kickers.radius + reach;
  const double expected = 0.25 * share * kickers.density * std::numbers::pi * side * side;
  return 1.0 - std::exp(-expected);
}

}  // namespace teamsight::fusion
