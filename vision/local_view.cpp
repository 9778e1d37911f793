// vision/local_view.cpp: see vision/local_view.hpp.
#include "vision/local_view.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace teamsight::vision {

namespace {

std::optional<Eigen::Vector3d> direction_at(const RayTable& rays, long u, long v) {
  if (u < 0 || v < 0 || u >= static_cast<long>(rays.width()) ||
      v >= static_cast<long>(rays.height())) {
    return std::nullopt;
  }
  const PixelRay& ray = rays.at(static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(v));
  if (!ray.sees_something()) return std::nullopt;
  return Eigen::Vector3f(ray.direction_x, ray.direction_y, ray.direction_z).cast<double>();
}

/// The first pixel that is at or behind `from`, in [0, count].
std::uint32_t first_at(double from, std::uint32_t count) {
  return static_cast<std::uint32_t>(std::clamp(std::ceil(from), 0.0, static_cast<double>(count)));
}

/// The first pixel that is behind `to`, in [0, count].
std::uint32_t first_behind(double to, std::uint32_t count) {
  return first_at(std::floor(to) + 1.0, count);
}

}  // namespace

PixelBox box_around(const LocalView& view, double radius, const RayTable& rays) {
  const double aside = radius * view.to_pixels.row(0).norm();
  const double above = radius * view.to_pixels.row(1).norm();
  return {first_at(view.middle.v - above, rays.height()),
          first_behind(view.middle.v + above, rays.height()),
          first_at(view.middle.u - aside, rays.width()),
          first_behind(view.middle.u + aside, rays.width())};
}

std::optional<LocalView> view_around(const RayTable& rays, const Pixel& middle, double span) {
  const long step = std::max(1L, std::lround(span));
  const long u = std::lround(middle.u);
  const long v = std::lround(middle.v);
  const auto left = direction_at(rays, u - step, v);
  const auto right = direction_at(rays, u + step, v);
  const auto above = direction_at(rays, u, v - step);
  const auto below = direction_at(rays, u, v + step);
  if (!left || !right || !above || !below) return std::nullopt;
  Eigen::Matrix<double, 3, 2> per_pixel;
  per_pixel.col(0) = (*right - *left) / (2.0 * static_cast<double>(step));
  per_pixel.col(1) = (*below - *above) / (2.0 * static_cast<double>(step));
  // The square root of the metric: angles along two directions at right angles.
  const Eigen::Matrix2d metric = per_pixel.transpose() * per_pixel;
  const double root = std::sqrt(std::max(0.0, metric.determinant()));
  const double trace = std::sqrt(metric.trace() + 2.0 * root);
  if (root <= 0.0 || trace <= 0.0) return std::nullopt;
  LocalView view;
  view.middle = middle;
  view.to_angles = (metric + root * Eigen::Matrix2d::Identity()) / trace;
  view.to_pixels = view.to_angles.inverse();
  return view;
}

}  // namespace teamsight::vision
