// bench/peers/solo_ball.cpp: see bench/peers/solo_ball.hpp.
#include "bench/peers/solo_ball.hpp"

#include <cmath>

namespace teamsight::peers {
namespace {

constexpr int kMostOutliers = 3;
constexpr double kForget = 0.66;     // s; 20 cycles of 33 ms
constexpr double kDeviation = 0.15;  // m beyond 3 sigma is an outlier
const fusion::PlanarMotion kMotion{4.0, 0.0};

double sigma_at(double distance) {
  return 0.01 * distance * distance - 0.01 * distance + 0.039;
}

/// Where the ray meets the plane of a lying ball's centre.
std::optional<Eigen::Vector2d> floor_point(const BallRay& ray,
                                           const Pose<Field, Robot>& X_FR,
                                           double ball_radius) {
  const Eigen::Vector3d& direction = ray.ray_R.direction;
  if (direction.z() > -0.02) return std::nullopt;
  const double reach = (ray.ray_R.origin.z - ball_radius) / -direction.z();
  const Point<Robot> p_RB{ray.ray_R.origin.x + reach * direction.x(),
                          ray.ray_R.origin.y + reach * direction.y()};
  return (X_FR * p_RB).vector();
}

}  // namespace

std::optional<Eigen::Vector2d> SoloBall::choose(const fusion::Observation& observation,
                                                double t,
                                                double ball_radius) const {
  std::optional<Eigen::Vector2d> best;
  double least = 1e9;
  const bool is_fresh = has_ball_ && t - last_seen_ < kForget;
  const Eigen::Vector2d expected =
      is_fresh ? Eigen::Vector2d(fusion::predicted(moments_, t - time_, kMotion).mean.head<2>())
               : observation.posture.X_FR.origin().vector();
  for (const BallRay& ray : observation.balls) {
    const auto p_F = floor_point(ray, observation.posture.X_FR, ball_radius);
    if (!p_F || (*p_F - expected).norm() >= least) continue;
    least = (*p_F - expected).norm();
    best = p_F;
  }
  return best;
}

void SoloBall::restart(const Eigen::Vector2d& p_F, double sigma) {
  moments_.mean << p_F, 0.0, 0.0;
  moments_.cov = Eigen::Vector4d(sigma * sigma, sigma * sigma, 9.0, 9.0).asDiagonal();
  outliers_ = 0;
}

void SoloBall::take(const fusion::Observation& observation, double t, double ball_radius) {
  if (t < time_) return;  // late ones are of no use to this filter
  const auto p_F = choose(observation, t, ball_radius);
  if (!p_F) return;
  observer_F_ = observation.posture.X_FR.origin().vector();
  distance_ = (*p_F - observer_F_).norm();
  const double sigma = sigma_at(distance_);
  const bool is_old = !has_ball_ || t - last_seen_ > kForget;
  if (!is_old) moments_ = fusion::predicted(moments_, t - time_, kMotion);
  time_ = t;
  const bool is_outlier =
      !is_old && (*p_F - moments_.mean.head<2>()).norm() > 3.0 * sigma + kDeviation;
  if (is_outlier && ++outliers_ < kMostOutliers) return;
  if (is_old || is_outlier) {
    restart(*p_F, sigma);
  } else {
    outliers_ = 0;
    fusion::PlanarFilter filter = fusion::PlanarFilter::from(moments_);
    filter.update({*p_F, sigma * sigma * Eigen::Matrix2d::Identity()});
    moments_ = filter.moments();
  }
  has_ball_ = true;
  last_seen_ = t;
}

BallGuess SoloBall::guess() const {
  return {moments_.mean.head<2>(), moments_.mean.tail<2>()};
}

double SoloBall::variance() const {
  return moments_.cov.topLeftCorner<2, 2>().trace();
}

}  // namespace teamsight::peers
