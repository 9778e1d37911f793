// vision/mirror_trace.cpp: intersection with a surface of revolution, and the law of reflection.
#include "vision/mirror_trace.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace teamsight::vision {

namespace {

Eigen::Matrix3d rotation(double about_x, double about_y, double about_z) {
  return (Eigen::AngleAxisd(about_z, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(about_y, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(about_x, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

}  // namespace

Eigen::Matrix3d head_rotation(double roll, double pitch) {
  return rotation(roll, pitch, 0.0);
}

MirrorTrace::MirrorTrace(const ProfileMirror& mirror, double image_right, bool flipped)
    : profile_(mirror.profile),
      focal_x_(mirror.focal_x_px),
      focal_y_(mirror.focal_y_px),
      flipped_(flipped),
      R_CM_(rotation(mirror.tilt_C[0], mirror.tilt_C[1], 0.0)),
      R_RM_(head_rotation(mirror.head_roll, mirror.head_pitch) * rotation(0.0, 0.0, image_right) *
            R_CM_),
      p_RC_(0.0, 0.0, mirror.pinhole_height),
      apex_(profile_.at(0.0).height) {
  // The mirror tilts about its apex and is then moved.
  const Eigen::Vector3d apex{0.0, 0.0, apex_};
  const Eigen::Vector3d offset{mirror.offset_C[0], mirror.offset_C[1], mirror.offset_C[2]};
  origin_M_ = R_CM_.transpose() * (-apex - offset) + apex;
}

std::optional<MirrorTrace::Hit> MirrorTrace::hit(const Eigen::Vector3d& sight_M) const {
  // Newton on the height of the mirror above the line of sight, from the apex' height. It converges
  // quadratically and a mirror bends by some 10 / m: behind a step this small 1e-13 m are left.
  constexpr double kLastStep = 1e-7;  // m
  constexpr int kMostSteps = 30;
  if (sight_M.z() <= 1e-6) return std::nullopt;
  double t = (apex_ - origin_M_.z()) / sight_M.z();
  bool is_last = false;
  for (int i = 0; i < kMostSteps; ++i) {
    const Eigen::Vector3d p = origin_M_ + t * sight_M;
    const double x = std::sqrt(p.x() * p.x() + p.y() * p.y());
    const auto [height, slope] = profile_.at(x);
    const Eigen::Vector2d out = x > 1e-12 ? (p.head<2>() / x).eval() : Eigen::Vector2d::Zero();
    if (is_last) {
      if (x < profile_.inner() || x > profile_.outer() || t <= 0.0) return std::nullopt;
      return Hit{p, Eigen::Vector3d(-slope * out.x(), -slope * out.y(), 1.0).normalized()};
    }
    const double closing = sight_M.z() - slope * out.dot(sight_M.head<2>());
    if (std::abs(closing) < 1e-9) return std::nullopt;
    const double change = (height - p.z()) / closing;
    t += change;
    is_last = std::abs(change) < kLastStep;
  }
  return std::nullopt;
}

std::optional<Ray<Robot>> MirrorTrace::trace(double du, double dv) const {
  const Eigen::Vector3d sight_C{du / focal_x_, (flipped_ ? -dv : dv) / focal_y_, 1.0};
  const Eigen::Vector3d sight_M = R_CM_.transpose() * sight_C.normalized();
  const auto seen = hit(sight_M);
  if (!seen) return std::nullopt;
  const Eigen::Vector3d away_M = sight_M - 2.0 * sight_M.dot(seen->normal_M) * seen->normal_M;
  Ray<Robot> ray;
  ray.origin = Point3<Robot>::from(p_RC_ + R_RM_ * (seen->p_M - origin_M_));
  ray.direction = R_RM_ * away_M;
  return ray;
}

}  // namespace teamsight::vision
