// tests/fusion/scenario.cpp: see tests/fusion/scenario.hpp.
#include "tests/fusion/scenario.hpp"

#include <cmath>

namespace teamsight::fusion::test {

FieldModel plain_field() {
  FieldModel field;
  field.length = 22.0;
  field.width = 14.0;
  field.surround = 1.0;
  return field;
}

double normal(Random& random, double sigma) {
  return std::normal_distribution<double>(0.0, sigma)(random);
}

void Eye::look(const Pose<Field, Robot>& X_FR, HostTime exposure, Random* random) {
  const std::uint32_t sequence = frame_.id.sequence + 1;
  truth_ = X_FR;
  frame_ = Observation{};
  frame_.id = {robot_, boot_, sequence};
  frame_.exposure = exposure;
  frame_.posture.status = PostureStatus::kOk;
  frame_.posture.X_FR = X_FR;
  if (random != nullptr) {
    frame_.posture.X_FR = {X_FR.x() + normal(*random, noise_.sigma_position),
                           X_FR.y() + normal(*random, noise_.sigma_position),
                           X_FR.theta() + normal(*random, noise_.sigma_heading)};
  }
  const double var = noise_.sigma_position * noise_.sigma_position;
  frame_.posture.cov.setZero();
  frame_.posture.cov.diagonal() << var, var, noise_.sigma_heading * noise_.sigma_heading;
}

void Eye::see_ball(const Point<Field>& p_FB, Random* random) {
  const Point<Robot> p_RB = truth_.inverse() * p_FB;
  double azimuth = std::atan2(p_RB.y, p_RB.x);
  double elevation = -std::atan2(kMirrorHeight - kBallRadius, p_RB.vector().norm());
  if (random != nullptr) {
    azimuth += normal(*random, noise_.sigma_direction);
    elevation += normal(*random, noise_.sigma_direction);
  }
  BallRay ray;
  ray.ray_R.origin = {0.0, 0.0, kMirrorHeight};
  ray.ray_R.direction = {std::cos(elevation) * std::cos(azimuth),
                         std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation)};
  ray.cov_direction = noise_.sigma_direction * noise_.sigma_direction * Eigen::Matrix2d::Identity();
  ray.confidence = 0.9;
  frame_.balls.push_back(ray);
}

void Eye::see_obstacle(const Point<Field>& p_FO, Random* random) {
  const Eigen::Vector2d centre_R = (truth_.inverse() * p_FO).vector();
  Eigen::Vector2d foot_R = centre_R * (1.0 - 0.25 / centre_R.norm());
  if (random != nullptr) {
    foot_R +=
        Eigen::Vector2d(normal(*random, noise_.sigma_foot), normal(*random, noise_.sigma_foot));
  }
  ObstacleSighting sighting;
  sighting.p_RO = Point<Robot>::from(foot_R);
  sighting.cov_R = noise_.sigma_foot * noise_.sigma_foot * Eigen::Matrix2d::Identity();
  sighting.width = 0.5;
  sighting.confidence = 0.9;
  frame_.obstacles.push_back(sighting);
}

}  // namespace teamsight::fusion::test
