// vision/ball_outline.cpp: the plane that cuts the unit sphere in the outline's directions.
#include "vision/ball_outline.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace teamsight::vision {

namespace {

constexpr std::size_t kFewest = 12;  // pixels, of an outline

Eigen::Vector3d direction_of(const PixelRay& ray) {
  return Eigen::Vector3f(ray.direction_x, ray.direction_y, ray.direction_z).cast<double>();
}

}  // namespace

void BallOutline::add(const PixelRay& ray) {
  const Eigen::Vector3d direction = direction_of(ray);
  const Eigen::Vector3d origin =
      Eigen::Vector3f(ray.origin_x, ray.origin_y, ray.origin_z).cast<double>();
  ++pixels;
  sum_direction += direction;
  sum_square += direction * direction.transpose();
  sum_across += origin - direction.dot(origin) * direction;
}

BallOutline& BallOutline::operator+=(const BallOutline& other) {
  pixels += other.pixels;
  cut += other.cut;
  sum_direction += other.sum_direction;
  sum_square += other.sum_square;
  sum_across += other.sum_across;
  return *this;
}

std::optional<BallCone> cone_of(const BallOutline& outline) {
  if (outline.pixels < kFewest) return std::nullopt;
  const auto count = static_cast<double>(outline.pixels);
  const Eigen::Vector3d mean = outline.sum_direction / count;
  const Eigen::Matrix3d spread = outline.sum_square / count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(spread);
  Eigen::Vector3d axis = axes.eigenvectors().col(0);
  if (axis.dot(mean) < 0.0) axis = -axis;
  BallCone cone;
  cone.angular_radius = std::acos(std::clamp(axis.dot(mean), -1.0, 1.0));
  if (cone.angular_radius <= 0.0) return std::nullopt;
  cone.sigma = std::sqrt(std::max(0.0, axes.eigenvalues()[0])) / std::sin(cone.angular_radius);
  const Eigen::Matrix3d across = count * Eigen::Matrix3d::Identity() - outline.sum_square;
  cone.axis_R = {Point3<Robot>::from(across.ldlt().solve(outline.sum_across)), axis};
  return cone;
}

double angular_radius_on_floor(const Ray<Robot>& ray_R, double ball_radius) {
  const double down = -ray_R.direction.z();
  const double height = ray_R.origin.z - ball_radius;
  if (down <= 0.0 || height <= 0.0) return 0.0;
  return std::asin(std::min(1.0, ball_radius * down / height));
}

}  // namespace teamsight::vision
