// vision/ball_range.cpp: see vision/ball_range.hpp.
#include "vision/ball_range.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::vision {

namespace {

constexpr int kSteps = 64;         // of the integral over ranges in the air
constexpr double kSurest = 6.9;    // log-odds; a thousand to one
constexpr double kLeast = 1e-300;  // of a density, so that it has a logarithm

double density(double gap, double sigma) {
  // But for a factor that both possibilities share.
  return std::exp(-0.5 * gap * gap / (sigma * sigma)) / sigma;
}

double size_at(double range, double ball_radius) {
  return std::asin(std::min(1.0, ball_radius / range));
}

// As far as the ray is followed; 0 where it does not come down so far.
double range_on_floor(const BallRay& ray, const BallRangeRules& rules) {
  const double down = -ray.ray_R.direction.z();
  const double height = ray.ray_R.origin.z - rules.ball_radius;
  if (down <= 0.0 || height <= 0.0) return 0.0;
  const double range = height / down;
  return range <= rules.farthest ? range : 0.0;
}

// Of the size that is seen, mean over all ranges where the ball may fly.
double density_in_air(const BallRay& ray, double farthest, const BallRangeRules& rules) {
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double range = rules.nearest + (farthest - rules.nearest) * (i + 0.5) / kSteps;
    sum +=
        density(ray.angular_radius - size_at(range, rules.ball_radius), ray.sigma_angular_radius);
  }
  return sum / kSteps;
}

double flying_log_odds(const BallRay& ray, const BallRange& range, const BallRangeRules& rules) {
  if (range.on_floor <= 0.0) return kSurest;
  if (range.by_size <= 0.0 || range.on_floor <= rules.nearest) return 0.0;
  const double size = size_at(range.on_floor, rules.ball_radius);
  const double sigma = std::tan(size) / range.on_floor * range.sigma_on_floor;
  const double on_floor =
      density(ray.angular_radius - size, std::hypot(sigma, ray.sigma_angular_radius));
  const double in_air = density_in_air(ray, range.on_floor, rules);
  return std::clamp(
      std::log(std::max(in_air, kLeast)) - std::log(std::max(on_floor, kLeast)), -kSurest, kSurest);
}

}  // namespace

BallRange range_of(const BallRay& ray, const BallRangeRules& rules) {
  BallRange range;
  range.on_floor = range_on_floor(ray, rules);
  if (range.on_floor > 0.0) {
    const double down = -ray.ray_R.direction.z();
    const double level = ray.ray_R.direction.head<2>().norm();
    const double sigma = std::hypot(std::sqrt(ray.cov_direction(1, 1)), rules.sigma_lean);
    range.sigma_on_floor = range.on_floor * level / down * sigma;
  }
  if (ray.angular_radius > 0.0 && ray.sigma_angular_radius > 0.0) {
    range.by_size = rules.ball_radius / std::sin(ray.angular_radius);
    range.sigma_by_size = range.by_size / std::tan(ray.angular_radius) * ray.sigma_angular_radius;
  }
  range.flying_log_odds = flying_log_odds(ray, range, rules);
  return range;
}

}  // namespace teamsight::vision
