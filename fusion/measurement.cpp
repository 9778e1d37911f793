// fusion/measurement.cpp: see fusion/measurement.hpp.
#include "fusion/measurement.hpp"

#include <cmath>

#include "geometry/uncertainty.hpp"

namespace teamsight::fusion {
namespace {

constexpr double kShallowest = 0.0087;   // rad; a flatter ray's range says nothing
constexpr double kContradiction = 8.81;  // chi-square, 1 degree, 99.7 %

/// Uses the ball's apparent size as a second range.
void add_apparent_size(const BallRay& ray, double elevation, double ball_radius, PolarBall& ball) {
  if (ray.angular_radius <= 0.0 || ray.sigma_angular_radius <= 0.0) return;
  const double range = ball_radius / std::sin(ray.angular_radius) * std::cos(elevation);
  const double slope = range / std::tan(ray.angular_radius);
  const double var = slope * slope * ray.sigma_angular_radius * ray.sigma_angular_radius;
  const double gap = range - ball.range;
  const double var_gap = ball.cov(1, 1) + var;
  if (gap * gap > kContradiction * var_gap) {
    ball.cov(1, 1) += gap * gap;
    return;
  }
  const Eigen::Vector2d gain = ball.cov.col(1) / var_gap;
  ball.azimuth += gain(0) * gap;
  ball.range += gain(1) * gap;
  ball.cov -= gain * gain.transpose() * var_gap;
}

PlanarMeasurement in_field(const PostureEstimate& posture,
                           const Point<Robot>& p_R,
                           const Eigen::Matrix2d& cov_R) {
  PlanarMeasurement measurement;
  measurement.p_F = (posture.X_FR * p_R).vector();
  const Eigen::Matrix2d cov = transform_covariance(posture.X_FR, posture.cov, p_R, cov_R);
  measurement.cov_F = 0.5 * (cov + cov.transpose());
  return measurement;
}

}  // namespace

double range_slope(double height, double elevation) {
  const double s = std::sin(elevation);
  return height / (s * s);
}

Eigen::Matrix2d polar_jacobian(double azimuth, double range) {
  const double c = std::cos(azimuth);
  const double s = std::sin(azimuth);
  return (Eigen::Matrix2d() << -range * s, c, range * c, s).finished();
}

std::optional<PolarBall> ball_on_floor(const BallRay& ray, double ball_radius) {
  const Eigen::Vector3d& direction = ray.ray_R.direction;
  const double height = ray.ray_R.origin.z - ball_radius;
  const double elevation = std::atan2(direction.z(), direction.head<2>().norm());
  if (height <= 0.0 || elevation > -kShallowest) return std::nullopt;
  PolarBall ball;
  ball.azimuth = std::atan2(direction.y(), direction.x());
  ball.range = height / std::tan(-elevation);
  const Eigen::Vector2d slope(1.0, range_slope(height, elevation));
  ball.cov = slope.asDiagonal() * ray.cov_direction * slope.asDiagonal();
  add_apparent_size(ray, elevation, ball_radius, ball);
  return ball;
}

std::optional<BallInSpace> ball_by_size(const BallRay& ray, double ball_radius) {
  if (ray.angular_radius <= 0.0 || ray.sigma_angular_radius <= 0.0) return std::nullopt;
  const Eigen::Vector3d& direction = ray.ray_R.direction;
  const double level = direction.head<2>().norm();
  if (level < 1e-9) return std::nullopt;
  const double distance = ball_radius / std::sin(ray.angular_radius);
  const double sigma = distance / std::tan(ray.angular_radius) * ray.sigma_angular_radius;
  Eigen::Matrix3d slope;  // by (azimuth, elevation, distance)
  slope.col(0) << -direction.y() * distance, direction.x() * distance, 0.0;
  slope.col(1) << -direction.x() / level * direction.z() * distance,
      -direction.y() / level * direction.z() * distance, level * distance;
  slope.col(2) = direction;
  Eigen::Matrix3d cov = Eigen::Matrix3d::Zero();
  cov.topLeftCorner<2, 2>() = ray.cov_direction;
  cov(2, 2) = sigma * sigma;
  return BallInSpace{ray.ray_R.origin.vector() + distance * direction,
                     slope * cov * slope.transpose()};
}

PlanarMeasurement below(const BallInSpace& ball, const PostureEstimate& posture) {
  return in_field(posture,
                  Point<Robot>::from(ball.p_R.head<2>()),
                  ball.cov.topLeftCorner<2, 2>() + 1e-6 * Eigen::Matrix2d::Identity());
}

std::optional<PlanarMeasurement> measure_ball(const BallRay& ray,
                                              const PostureEstimate& posture,
                                              double ball_radius) {
  const auto ball = ball_on_floor(ray, ball_radius);
  if (!ball) return std::nullopt;
  const Point<Robot> p_RB{ray.ray_R.origin.x + ball->range * std::cos(ball->azimuth),
                          ray.ray_R.origin.y + ball->range * std::sin(ball->azimuth)};
  const Eigen::Matrix2d jacobian = polar_jacobian(ball->azimuth, ball->range);
  // Straight below the mirror the azimuth says nothing and the Jacobian is singular: never claim
  // more than a millimetre.
  const Eigen::Matrix2d cov_R =
      jacobian * ball->cov * jacobian.transpose() + 1e-6 * Eigen::Matrix2d::Identity();
  return in_field(posture, p_RB, cov_R);
}

PlanarMeasurement measure_obstacle(const ObstacleSighting& sighting,
                                   const PostureEstimate& posture,
                                   double radius) {
  const Eigen::Vector2d foot_R = sighting.p_RO.vector();
  const double distance = foot_R.norm();
  const Eigen::Vector2d centre_R =
      distance > 1e-6 ? Eigen::Vector2d(foot_R * (1.0 + radius / distance)) : foot_R;
  return in_field(posture, Point<Robot>::from(centre_R), sighting.cov_R);
}

double radius_of(const ObstacleSighting& sighting, double fallback) {
  const double half = 0.5 * sighting.width;
  return half >= 0.05 && half <= 0.6 ? half : fallback;
}

}  // namespace teamsight::fusion
