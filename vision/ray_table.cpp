// vision/ray_table.cpp: one ray per pixel, footprints from the neighbours.
#include "vision/ray_table.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace teamsight::vision {

namespace {

constexpr PixelRay kBlind{.floor_x = std::numeric_limits<float>::quiet_NaN(),
                          .floor_y = std::numeric_limits<float>::quiet_NaN()};

PixelRay look_along(const CameraModel& model, double u, double v) {
  PixelRay entry;
  entry.floor_x = std::numeric_limits<float>::quiet_NaN();
  entry.floor_y = entry.floor_x;
  const auto ray = model.ray({u, v});
  if (!ray) return entry;
  entry.origin_x = static_cast<float>(ray->origin.x);
  entry.origin_y = static_cast<float>(ray->origin.y);
  entry.origin_z = static_cast<float>(ray->origin.z);
  entry.direction_x = static_cast<float>(ray->direction.x());
  entry.direction_y = static_cast<float>(ray->direction.y());
  entry.direction_z = static_cast<float>(ray->direction.z());
  if (const auto floor = meet_plane(*ray, 0.0)) {
    entry.floor_x = static_cast<float>(floor->x);
    entry.floor_y = static_cast<float>(floor->y);
  }
  return entry;
}

// How the floor moves when a pixel is left, along and across the line of sight. `away` and `back`
// are neighbours in a row or column; either may be missing at the rim.
Eigen::Vector2f floor_step(const PixelRay& here, const PixelRay& away, const PixelRay& back) {
  const Eigen::Vector2f p{here.floor_x, here.floor_y};
  const Eigen::Vector2f a{away.floor_x, away.floor_y};
  const Eigen::Vector2f b{back.floor_x, back.floor_y};
  if (away.sees_floor() && back.sees_floor()) return 0.5F * (a - b);
  if (away.sees_floor()) return a - p;
  if (back.sees_floor()) return p - b;
  return Eigen::Vector2f::Zero();
}

void set_footprint(PixelRay& here, const Eigen::Vector2f& step_u, const Eigen::Vector2f& step_v) {
  Eigen::Vector2f outwards{here.floor_x, here.floor_y};
  if (outwards.norm() < 1e-6F) outwards = Eigen::Vector2f::UnitX();
  outwards.normalize();
  const Eigen::Vector2f across{-outwards.y(), outwards.x()};
  // Root of the sum of squares: the length of the gradient, whatever the direction in the picture.
  here.radial_footprint = std::hypot(outwards.dot(step_u), outwards.dot(step_v));
  here.tangential_footprint = std::hypot(across.dot(step_u), across.dot(step_v));
}

}  // namespace

RayTable::RayTable(const CameraModel& model, std::uint32_t width_px, std::uint32_t height_px)
    : width_(width_px),
      height_(height_px) {
  rays_.reserve(std::size_t{width_px} * height_px);
  for (std::uint32_t v = 0; v < height_; ++v) {
    for (std::uint32_t u = 0; u < width_; ++u) rays_.push_back(look_along(model, u, v));
  }
  for (std::uint32_t v = 0; v < height_; ++v) {
    for (std::uint32_t u = 0; u < width_; ++u) {
      PixelRay& here = rays_[std::size_t{v} * width_ + u];
      if (here.sees_floor()) set_footprint(here, step_along_u(u, v), step_along_v(u, v));
    }
  }
}

// Beyond the border of the image nothing is seen: floor_step then uses the other neighbour alone.
Eigen::Vector2f RayTable::step_along_u(std::uint32_t u, std::uint32_t v) const {
  return floor_step(
      at(u, v), u + 1 < width_ ? at(u + 1, v) : kBlind, u > 0 ? at(u - 1, v) : kBlind);
}

Eigen::Vector2f RayTable::step_along_v(std::uint32_t u, std::uint32_t v) const {
  return floor_step(
      at(u, v), v + 1 < height_ ? at(u, v + 1) : kBlind, v > 0 ? at(u, v - 1) : kBlind);
}

std::optional<double> eye_height(const RayTable& rays) {
  double sum = 0.0;
  double count = 0.0;
  const std::size_t pixels = std::size_t{rays.width()} * rays.height();
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!rays[i].sees_floor()) continue;
    sum += static_cast<double>(rays[i].origin_z);
    count += 1.0;
  }
  if (count == 0.0) return std::nullopt;
  return sum / count;
}

float solid_angle_of(const RayTable& rays, std::uint32_t u, std::uint32_t v) {
  const auto direction = [&](std::uint32_t column, std::uint32_t row) {
    const PixelRay& ray = rays.at(column, row);
    return Eigen::Vector3f(ray.direction_x, ray.direction_y, ray.direction_z);
  };
  if (u + 1 >= rays.width() || v + 1 >= rays.height()) return 0.0F;
  if (!rays.at(u, v).sees_something() || !rays.at(u + 1, v).sees_something() ||
      !rays.at(u, v + 1).sees_something()) {
    return 0.0F;
  }
  const Eigen::Vector3f here = direction(u, v);
  return (direction(u + 1, v) - here).cross(direction(u, v + 1) - here).norm();
}

}  // namespace teamsight::vision
