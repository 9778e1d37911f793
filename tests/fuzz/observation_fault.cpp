// tests/fuzz/observation_fault.cpp: see observation_fault.hpp.
#include "tests/fuzz/observation_fault.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teamsight::fuzz {
namespace {

bool is_share(double value) {
  return value >= 0.0 && value <= 1.0;
}

template <class Matrix>
bool is_covariance(const Matrix& cov) {
  return cov.allFinite() && cov.diagonal().minCoeff() >= 0.0;
}

bool is_sound(const PostureEstimate& posture) {
  return posture.X_FR.origin().vector().allFinite() && std::isfinite(posture.X_FR.theta()) &&
         is_covariance(posture.cov) && std::isfinite(posture.half_log_odds) &&
         is_share(posture.inlier_ratio);
}

bool is_sound(const BallRay& ball) {
  return ball.ray_R.origin.vector().allFinite() &&
         std::abs(ball.ray_R.direction.norm() - 1.0) < 1e-6 && ball.angular_radius >= 0.0 &&
         ball.angular_radius < std::numbers::pi && std::isfinite(ball.sigma_angular_radius) &&
         is_covariance(ball.cov_direction) && is_share(ball.confidence);
}

bool is_sound(const ObstacleSighting& obstacle) {
  return obstacle.p_RO.vector().allFinite() && is_covariance(obstacle.cov_R) &&
         std::isfinite(obstacle.width) && obstacle.width >= 0.0 && is_share(obstacle.confidence) &&
         is_share(obstacle.teammate_likelihood);
}

bool is_sound(const vision::LinePoint& point) {
  return std::isfinite(point.u_px) && std::isfinite(point.v_px) && point.p_R.vector().allFinite() &&
         is_covariance(point.cov_R);
}

bool is_sound(const vision::FreeSpace& free) {
  return std::isfinite(free.azimuth) && std::isfinite(free.distance) && free.distance >= 0.0;
}

bool is_sound(const vision::SeenGoal& goal) {
  return std::isfinite(goal.azimuth) && std::isfinite(goal.left) && std::isfinite(goal.right) &&
         (!goal.distance || (std::isfinite(*goal.distance) && *goal.distance >= 0.0));
}

bool is_sound(const vision::Carpet& carpet) {
  return std::isfinite(carpet.luminance) && std::isfinite(carpet.u) && std::isfinite(carpet.v) &&
         is_share(static_cast<double>(carpet.share));
}

template <class List>
bool are_sound(const List& list) {
  return std::ranges::all_of(list, [](const auto& one) { return is_sound(one); });
}

}  // namespace

std::string fault_of(const vision::FrameObservation& seen) {
  if (!is_sound(seen.posture)) return "posture";
  if (!are_sound(seen.balls) || seen.balls.size() != seen.ball_pixels.size() ||
      seen.balls.size() > kMaxBallRays) {
    return "balls";
  }
  if (!are_sound(seen.obstacles) || seen.obstacles.size() != seen.obstacle_pixels.size() ||
      seen.obstacles.size() > kMaxObstacleSightings) {
    return "obstacles";
  }
  if (!are_sound(seen.line_points) || seen.line_points.size() > vision::kMaxLinePoints) {
    return "line points";
  }
  if (seen.line_residuals.size() != seen.line_fits.size()) return "line residuals";
  if (!are_sound(seen.free_space)) return "free space";
  if (!are_sound(seen.goals)) return "goals";
  if (!is_sound(seen.carpet)) return "carpet";
  if (!seen.drift.info.allFinite() || !seen.drift.vector.allFinite()) return "drift";
  const bool are_shares = std::ranges::all_of(
      seen.sensors, [](const vision::SensorValue& sensor) { return is_share(sensor.value); });
  return are_shares ? "" : "virtual sensors";
}

}  // namespace teamsight::fuzz
