// tests/vision/mirror/ray_tracer.cpp: intersection by bisection, normals by differences.
#include "tests/vision/mirror/ray_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teamsight::test {
namespace {

Vector3 minus(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 move(const Vector3& from, const Vector3& direction, double length) {
  return {from[0] + length * direction[0],
          from[1] + length * direction[1],
          from[2] + length * direction[2]};
}

}  // namespace

Surface::Surface(std::vector<std::array<double, 2>> points, bool is_round_inside)
    : points_(std::move(points)),
      inner_(points_.front()[0]) {
  if (is_round_inside) {
    const std::vector<std::array<double, 2>> half = points_;
    for (std::size_t i = 1; i <= 5 && i < half.size(); ++i) {
      points_.insert(points_.begin(), {-half[i][0], half[i][1]});
    }
  }
}

double Surface::height(double distance) const {
  constexpr std::size_t kOrder = 6;
  const auto above = std::lower_bound(
      points_.begin(), points_.end(), distance, [](const auto& p, double x) { return p[0] < x; });
  const auto index = static_cast<std::size_t>(above - points_.begin());
  const std::size_t count = std::min(kOrder, points_.size());
  const std::size_t first = std::min(index > 3 ? index - 3 : 0, points_.size() - count);
  std::vector<double> y(count);  // Neville's scheme
  for (std::size_t i = 0; i < count; ++i) {
    y[i] = points_[first + i][1];
  }
  for (std::size_t level = 1; level < count; ++level) {
    for (std::size_t i = 0; i + level < count; ++i) {
      const double a = points_[first + i][0];
      const double b = points_[first + i + level][0];
      y[i] = ((distance - b) * y[i] + (a - distance) * y[i + 1]) / (a - b);
    }
  }
  return y[0];
}

Vector3 Surface::embed(double distance, double azimuth) const {
  return {distance * std::cos(azimuth), distance * std::sin(azimuth), height(distance)};
}

Vector3 Surface::normal(double distance, double azimuth) const {
  constexpr double kStep = 1e-5;  // m
  const Vector3 outwards =
      minus(embed(distance + kStep, azimuth), embed(distance - kStep, azimuth));
  const Vector3 around{-std::sin(azimuth), std::cos(azimuth), 0.0};
  return cross(around, outwards);
}

std::optional<TracedRay> Surface::reflect(const Vector3& direction) const {
  const double run = radius_of(direction);
  const auto above = [&](double distance) {  // the ray over the surface, at this distance
    return distance / run * direction[2] - height(distance);
  };
  double low = inner();
  double high = outer();
  if (run <= 0.0 || above(low) > 0.0 || above(high) < 0.0) {
    return std::nullopt;
  }
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (above(middle) < 0.0 ? low : high) = middle;
  }
  const double distance = 0.5 * (low + high);
  const Vector3 n = normal(distance, std::atan2(direction[1], direction[0]));
  const Vector3 hit = move({}, direction, distance / run);
  return TracedRay{hit, move(direction, n, -2.0 * dot(direction, n) / dot(n, n))};
}

Vector3 camera_ray(double tan_alpha, double azimuth) {
  return {tan_alpha * std::cos(azimuth), tan_alpha * std::sin(azimuth), 1.0};
}

std::optional<Vector3> at_height(const TracedRay& ray, double z) {
  if (ray.direction[2] >= 0.0) {
    return std::nullopt;
  }
  return move(ray.origin, ray.direction, (z - ray.origin[2]) / ray.direction[2]);
}

Vector3 at_distance(const TracedRay& ray, double distance) {
  // |origin + s direction| = distance in the plane: the later of two solutions
  const double a = ray.direction[0] * ray.direction[0] + ray.direction[1] * ray.direction[1];
  const double b = ray.direction[0] * ray.origin[0] + ray.direction[1] * ray.origin[1];
  const double c = radius_of(ray.origin) * radius_of(ray.origin) - distance * distance;
  return move(ray.origin, ray.direction, (-b + std::sqrt(b * b - a * c)) / a);
}

double radius_of(const Vector3& point) {
  return std::hypot(point[0], point[1]);
}

bool meets_again(const TracedRay& ray, const std::vector<Surface>& surfaces, double step) {
  for (const Surface& surface : surfaces) {
    const double from = std::max(surface.inner(), radius_of(ray.origin) + step);
    for (double distance = from; distance <= surface.outer(); distance += step) {
      if (at_distance(ray, distance)[2] >= surface.height(distance)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace teamsight::test
