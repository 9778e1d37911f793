// vision/camera_model.cpp: the two kinds of mirror behind one face.
#include "vision/camera_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "geometry/angle.hpp"

namespace teamsight::vision {

namespace {

MonotoneCurve angle_curve(const RadialTable& table) {
  std::vector<Knot> knots;
  for (const RingMark& row : table.rows) {
    knots.push_back({row.radius_px, std::atan2(row.distance, table.mirror_height)});
  }
  return MonotoneCurve(std::move(knots));
}

Pixel centre_of(const CameraParameters& parameters) {
  return std::visit(
      [](const auto& mirror) {
        return Pixel{mirror.centre_u_px, mirror.centre_v_px};
      },
      parameters.mirror);
}

}  // namespace

CameraModel::CameraModel(const CameraParameters& parameters)
    : centre_(centre_of(parameters)),
      forward_(parameters.forward),
      mirrored_(parameters.mirrored),
      eye_([&]() -> std::variant<Radial, MirrorTrace> {
        if (const auto* table = std::get_if<RadialTable>(&parameters.mirror)) {
          return Radial{angle_curve(*table),
                        table->mirror_height,
                        head_rotation(table->head_roll, table->head_pitch)};
        }
        // A camera that looks up has x towards image right and y towards image bottom, so its
        // picture is mirrored; one that is not was turned over, which also turns `forward`.
        const double forward = parameters.mirrored ? parameters.forward : -parameters.forward;
        return MirrorTrace(
            std::get<ProfileMirror>(parameters.mirror), forward, !parameters.mirrored);
      }()) {}

double CameraModel::image_direction(double azimuth) const {
  return wrap_angle(mirrored_ ? forward_ - azimuth : forward_ + azimuth);
}

double CameraModel::azimuth(double image_direction) const {
  return wrap_angle(mirrored_ ? forward_ - image_direction : image_direction - forward_);
}

std::optional<Ray<Robot>> CameraModel::ray(const Pixel& pixel) const {
  const double du = pixel.u - centre_.u;
  const double dv = pixel.v - centre_.v;
  if (const auto* mirror = std::get_if<MirrorTrace>(&eye_)) return mirror->trace(du, dv);
  return radial_ray(std::get<Radial>(eye_), du, dv);
}

std::optional<Ray<Robot>> CameraModel::radial_ray(const Radial& radial,
                                                  double du,
                                                  double dv) const {
  const double radius = std::hypot(du, dv);
  const MonotoneCurve& curve = radial.angle_from_down;
  if (radius < curve.first().x || radius > curve.last().x) return std::nullopt;
  const double angle = curve.at(radius);
  const double heading = azimuth(std::atan2(-dv, du));
  Ray<Robot> ray;
  ray.origin = {0.0, 0.0, radial.viewpoint_height};
  ray.direction = radial.R_RH * Eigen::Vector3d(std::sin(angle) * std::cos(heading),
                                                std::sin(angle) * std::sin(heading),
                                                -std::cos(angle));
  return ray;
}

std::optional<Point<Robot>> CameraModel::on_plane(const Pixel& pixel, double height) const {
  const auto seen = ray(pixel);
  return seen ? meet_plane(*seen, height) : std::nullopt;
}

std::optional<Pixel> CameraModel::project(const Point3<Robot>& p_R) const {
  const auto* radial = std::get_if<Radial>(&eye_);
  return radial != nullptr ? project_radial(*radial, p_R) : project_through_mirror(p_R);
}

std::optional<Pixel> CameraModel::project_radial(const Radial& radial,
                                                 const Point3<Robot>& p_R) const {
  const Eigen::Vector3d sight_H =
      radial.R_RH.transpose() * Eigen::Vector3d(p_R.x, p_R.y, p_R.z - radial.viewpoint_height);
  const double angle = std::atan2(sight_H.head<2>().norm(), -sight_H.z());
  const MonotoneCurve& curve = radial.angle_from_down;
  if (angle < curve.first().y || angle > curve.last().y) return std::nullopt;
  const double radius = curve.inverse(angle);
  const double direction = image_direction(std::atan2(sight_H.y(), sight_H.x()));
  return Pixel{centre_.u + radius * std::cos(direction), centre_.v - radius * std::sin(direction)};
}

std::optional<Eigen::Vector2d> CameraModel::miss(const Pixel& pixel,
                                                 const Point3<Robot>& p_R) const {
  const auto seen = ray(pixel);
  if (!seen) return std::nullopt;
  const Eigen::Vector3d towards = p_R.vector() - seen->origin.vector();
  const double elevation = std::atan2(seen->direction.z(), seen->direction.head<2>().norm());
  const double wanted = std::atan2(towards.z(), towards.head<2>().norm());
  const double heading = std::atan2(seen->direction.y(), seen->direction.x());
  return Eigen::Vector2d(elevation - wanted,
                         angle_difference(heading, std::atan2(towards.y(), towards.x())));
}

std::optional<Pixel> CameraModel::project_on_meridian(const Point3<Robot>& p_R) const {
  const double direction = image_direction(std::atan2(p_R.y, p_R.x));
  const auto pixel_at = [&](double radius) {
    return Pixel{centre_.u + radius * std::cos(direction),
                 centre_.v - radius * std::sin(direction)};
  };
  // Whether the ray at this radius passes below the point; nothing beside the mirror.
  const auto is_below = [&](double radius) -> std::optional<bool> {
    const auto here = miss(pixel_at(radius), p_R);
    return here ? std::optional(here->x() < 0.0) : std::nullopt;
  };
  constexpr int kStride = 8;  // px; the mirror's rays rise outwards
  constexpr int kFarthest = 4096;
  double low = 0.0;
  double high = 0.0;
  for (int radius = 1; radius < kFarthest; radius += kStride) {
    const auto below = is_below(radius);
    if (below == true) low = radius;
    if (below == false) high = radius;
    if (high > 0.0) break;
  }
  if (low == 0.0 || high == 0.0) return std::nullopt;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (low + high);
    (is_below(middle) == true ? low : high) = middle;
  }
  return pixel_at(0.5 * (low + high));
}

std::optional<Pixel> CameraModel::project_through_mirror(const Point3<Robot>& p_R) const {
  const auto start = project_on_meridian(p_R);
  if (!start) return std::nullopt;
  // With offsets and tilts the direction in the picture differs a little: two-dimensional Newton.
  Pixel pixel = *start;
  for (int i = 0; i < 8; ++i) {
    constexpr double kNudge = 0.01;  // px
    const auto here = miss(pixel, p_R);
    const auto right = miss({pixel.u + kNudge, pixel.v}, p_R);
    const auto below = miss({pixel.u, pixel.v + kNudge}, p_R);
    if (!here || !right || !below) return std::nullopt;
    Eigen::Matrix2d slope;
    slope.col(0) = (*right - *here) / kNudge;
    slope.col(1) = (*below - *here) / kNudge;
    const Eigen::Vector2d change = slope.fullPivLu().solve(-*here);
    pixel = {pixel.u + change.x(), pixel.v + change.y()};
    if (change.norm() < 1e-9) break;
  }
  return miss(pixel, p_R) ? std::optional(pixel) : std::nullopt;
}

std::optional<Eigen::Matrix2d> CameraModel::floor_jacobian(const Pixel& pixel) const {
  constexpr double kNudge = 0.25;  // px
  const std::array<std::optional<Point<Robot>>, 4> around{
      on_plane({pixel.u - kNudge, pixel.v}, 0.0),
      on_plane({pixel.u + kNudge, pixel.v}, 0.0),
      on_plane({pixel.u, pixel.v - kNudge}, 0.0),
      on_plane({pixel.u, pixel.v + kNudge}, 0.0)};
  if (!std::ranges::all_of(around, [](const auto& p) { return p.has_value(); })) {
    return std::nullopt;
  }
  Eigen::Matrix2d jacobian;
  jacobian.col(0) = (around[1]->vector() - around[0]->vector()) / (2.0 * kNudge);
  jacobian.col(1) = (around[3]->vector() - around[2]->vector()) / (2.0 * kNudge);
  return jacobian;
}

}  // namespace teamsight::vision
