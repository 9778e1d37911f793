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
      R_RC_(head_rotation(mirror.head_roll, mirror.head_pitch) * rotation(0.0, 0.0, image_right)),
      p_RC_(0.0, 0.0, mirror.pinhole_height) {
  // The mirror tilts about its apex and is then moved.
  const Eigen::Vector3d apex{0.0, 0.0, profile_.height(0.0)};
  const Eigen::Vector3d offset{mirror.offset_C[0], mirror.offset_C[1], mirror.offset_C[2]};
  origin_M_ = R_CM_.transpose() * (-apex - offset) + apex;
}

std::optional<Eigen::Vector3d> MirrorTrace::hit(const Eigen::Vector3d& origin_M,
                                                const Eigen::Vector3d& sight_M) const {
  if (sight_M.z() <= 1e-6) return std::nullopt;
  // Newton on the height of the line of sight above the mirror; starts at the apex' height.
  double t = (profile_.height(0.0) - origin_M.z()) / sight_M.z();
  Eigen::Vector3d p = origin_M + t * sight_M;
  for (int i = 0; i < 30; ++i) {
    const double x = p.head<2>().norm();
    const double above = p.z() - profile_.height(x);
    const double outwards = x > 1e-12 ? p.head<2>().dot(sight_M.head<2>()) / x : 0.0;
    const double closing = sight_M.z() - profile_.slope(x) * outwards;
    if (std::abs(closing) < 1e-9) return std::nullopt;
    const double change = -above / closing;
    t += change;
    p = origin_M + t * sight_M;
    if (std::abs(change) < 1e-12) break;
  }
  const double x = p.head<2>().norm();
  const bool on_mirror =
      x >= profile_.inner() && x <= profile_.outer() && std::abs(p.z() - profile_.height(x)) < 1e-9;
  return on_mirror && t > 0.0 ? std::optional(p) : std::nullopt;
}

std::optional<Ray<Robot>> MirrorTrace::trace(double du, double dv) const {
  const Eigen::Vector3d sight_C{du / focal_x_, (flipped_ ? -dv : dv) / focal_y_, 1.0};
  const Eigen::Vector3d sight_M = R_CM_.transpose() * sight_C.normalized();
  const auto p_M = hit(origin_M_, sight_M);
  if (!p_M) return std::nullopt;
  const double x = p_M->head<2>().norm();
  const double slope = profile_.slope(x);
  Eigen::Vector3d normal{0.0, 0.0, 1.0};
  if (x > 1e-12) normal.head<2>() = -slope * p_M->head<2>() / x;
  normal.normalize();
  const Eigen::Vector3d away_M = sight_M - 2.0 * sight_M.dot(normal) * normal;
  Ray<Robot> ray;
  const Eigen::Vector3d p_C = R_CM_ * (*p_M - origin_M_);
  ray.origin = Point3<Robot>::from(p_RC_ + R_RC_ * p_C);
  ray.direction = (R_RC_ * (R_CM_ * away_M)).normalized();
  return ray;
}

}  // namespace teamsight::vision
