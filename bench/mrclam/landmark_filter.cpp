// bench/mrclam/landmark_filter.cpp: see bench/mrclam/landmark_filter.hpp.
#include "bench/mrclam/landmark_filter.hpp"

#include <cmath>

#include <Eigen/LU>

#include "geometry/angle.hpp"

namespace teamsight::mrclam {

LandmarkFilter::LandmarkFilter(const SenseErrors& errors, const Pose<Field, Robot>& start)
    : errors_(errors),
      mean_(start.vector()),
      cov_(Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()) {}

void LandmarkFilter::roll(const Wheels& wheels, double dt) {
  const double c = std::cos(mean_(2) + 0.5 * wheels.omega * dt);
  const double s = std::sin(mean_(2) + 0.5 * wheels.omega * dt);
  const double way = wheels.v * dt;
  mean_ += Eigen::Vector3d(c * way, s * way, wheels.omega * dt);
  mean_(2) = wrap_angle(mean_(2));
  Eigen::Matrix3d slope = Eigen::Matrix3d::Identity();
  slope(0, 2) = -s * way;
  slope(1, 2) = c * way;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << c, -s, s, c;
  const Eigen::Vector3d noise =
      dt * Eigen::Vector3d(errors_.sigma_forward, errors_.sigma_sideways, errors_.sigma_turn)
               .cwiseAbs2();
  cov_ = slope * cov_ * slope.transpose() + turn * noise.asDiagonal() * turn.transpose();
}

void LandmarkFilter::look(const Seen& seen, const Eigen::Vector2d& p_F) {
  const Eigen::Vector2d way = p_F - mean_.head<2>();
  const double range = way.norm();
  if (range < 0.1) return;
  const Eigen::Vector2d gap(
      seen.range - range, angle_difference(seen.bearing, std::atan2(way.y(), way.x()) - mean_(2)));
  Eigen::Matrix<double, 2, 3> slope;
  slope << -way.x() / range, -way.y() / range, 0.0,  //
      way.y() / (range * range), -way.x() / (range * range), -1.0;
  Eigen::Matrix2d noise = Eigen::Matrix2d::Zero();
  noise.diagonal() << errors_.sigma_range * errors_.sigma_range,
      errors_.sigma_bearing * errors_.sigma_bearing;
  const Eigen::Matrix2d inverse = (slope * cov_ * slope.transpose() + noise).inverse();
  if (gap.dot(inverse * gap) > errors_.gate) return;
  const Eigen::Matrix<double, 3, 2> gain = cov_ * slope.transpose() * inverse;
  mean_ += gain * gap;
  mean_(2) = wrap_angle(mean_(2));
  const Eigen::Matrix3d kept = Eigen::Matrix3d::Identity() - gain * slope;
  cov_ = kept * cov_ * kept.transpose() + gain * noise * gain.transpose();
}

}  // namespace teamsight::mrclam
