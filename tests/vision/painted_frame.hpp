// tests/vision/painted_frame.hpp: small pictures of a field, painted ray by ray, and an eye for
// them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "tests/vision/synthetic_points.hpp"
#include "vision/perception.hpp"

namespace teamsight::vision {

inline constexpr std::uint32_t kWidth = 320;
inline constexpr std::uint32_t kHeight = 240;

inline CameraParameters small_camera() {
  CameraParameters camera;
  camera.name = "small";
  camera.width_px = kWidth;
  camera.height_px = kHeight;
  camera.format = PixelFormat::kYuyv;
  camera.forward = 0.5 * std::numbers::pi;
  camera.mirrored = true;
  RadialTable table;
  table.centre_u_px = 159.5;
  table.centre_v_px = 119.5;
  table.mirror_height = 0.75;
  for (int radius = 15; radius <= 118; radius += 5) {
    table.rows.push_back({1.0 * radius, 1.57 * std::tan(0.0118 * radius), 0.1});
  }
  camera.mirror = table;
  camera.mask.inner_radius_px = 20.0;
  camera.scan.max_distance = 6.0;
  camera.colours.white_min_y = 150;
  camera.colours.black_max_y = 40;
  camera.colours.samples = {{ColourClass::kGreen, 101, 94, 24}, {ColourClass::kBall, 61, 200, 30}};
  return camera;
}

// The same eye with a sensor of more pixels.
inline CameraParameters large_camera() {
  constexpr double kScale = 4.0;
  CameraParameters camera = small_camera();
  camera.width_px = 1280;
  camera.height_px = 1024;
  auto& table = std::get<RadialTable>(camera.mirror);
  table.centre_u_px = 639.5;
  table.centre_v_px = 511.5;
  for (RingMark& row : table.rows) row.radius_px *= kScale;
  camera.mask.inner_radius_px *= kScale;
  return camera;
}

struct Paint {
  int y{0};
  int u{128};
  int v{128};
};

inline constexpr Paint kGreen{87, 101, 94};
inline constexpr Paint kWhite{230, 128, 128};
inline constexpr Paint kOrange{139, 61, 200};
inline constexpr Paint kBlack{20, 128, 128};

/// A ball's paints: in octants, four of each, or all of the first.
struct BallPaint {
  Paint first{kOrange};
  Paint second{kOrange};
  Eigen::AngleAxisd turn{0.0, Eigen::Vector3d::UnitZ()};  ///< from the ball's own frame to R
};

/// What stands on the field besides the paint.
struct Scene {
  Pose<Field, Robot> X_FR;
  std::optional<Point3<Robot>> ball;    // of 0.11 m
  std::optional<Point<Robot>> pillar;   // black, radius 0.25 m
  Paint shirt{kBlack};                  // of the pillar, from 0.25 to 0.55 m
  std::vector<Point<Robot>> pillars{};  // more of them, black
  double pillars_radius{0.25};          // m, of those
  BallPaint ball_paint{};
  Paint marker{kBlack};  // of the pillars, in patches around the foot
};

inline std::optional<Paint> look_at_ball(const Ray<Robot>& ray, const Scene& scene) {
  constexpr double kRadius = 0.11;
  if (!scene.ball) return std::nullopt;
  const Eigen::Vector3d to_ball = scene.ball->vector() - ray.origin.vector();
  const double along = to_ball.dot(ray.direction);
  const Eigen::Vector3d off = along * ray.direction - to_ball;
  if (along <= 0.0 || off.norm() >= kRadius) return std::nullopt;
  const double depth = std::sqrt(kRadius * kRadius - off.squaredNorm());
  const Eigen::Vector3d place = scene.ball_paint.turn.inverse() * (off - depth * ray.direction);
  return place.prod() > 0.0 ? scene.ball_paint.second : scene.ball_paint.first;
}

// How a pillar looks: black but for its shirt and its marker.
struct PillarPaint {
  Paint shirt{kBlack};
  Paint marker{kBlack};  // in patches around the foot
  double radius{0.25};   // m
};

// What the ray meets of a pillar: the way to the floor passes over its disc.
inline std::optional<Paint> look_at_pillar(const Ray<Robot>& ray,
                                           const Point<Robot>& p_R,
                                           const PillarPaint& paint) {
  const auto floor = meet_plane(ray, 0.0);
  const Eigen::Vector2d p = p_R.vector();
  const Eigen::Vector2d away = ray.direction.head<2>().normalized();
  const double along = p.dot(away);
  const double reach = floor ? floor->vector().norm() : 1e9;
  if (along <= 0.0 || (p - along * away).norm() >= paint.radius ||
      reach <= p.norm() - paint.radius) {
    return std::nullopt;
  }
  const double slope = ray.direction.z() / ray.direction.head<2>().norm();
  const double height = ray.origin.z + slope * (along - paint.radius);
  if (height > 0.25 && height < 0.55) return paint.shirt;
  // Patches of 0.1 m, as teams stick markers on their robots.
  const double aside = p.x() * away.y() - p.y() * away.x();
  const bool is_patch = height > 0.05 && height < 0.15 && std::abs(std::abs(aside) - 0.1) < 0.05;
  return is_patch ? paint.marker : kBlack;
}

inline Paint look(const Ray<Robot>& ray, const FieldModel& field, const Scene& scene) {
  if (const auto paint = look_at_ball(ray, scene)) return *paint;
  const auto floor = meet_plane(ray, 0.0);
  for (const Point<Robot>& pillar : scene.pillars) {
    const PillarPaint paint{kBlack, scene.marker, scene.pillars_radius};
    if (const auto seen = look_at_pillar(ray, pillar, paint)) return *seen;
  }
  if (scene.pillar) {
    const PillarPaint paint{scene.shirt, scene.marker};
    if (const auto seen = look_at_pillar(ray, *scene.pillar, paint)) return *seen;
  }
  if (!floor) return kBlack;
  const Point<Field> p_F = scene.X_FR * *floor;
  if (!is_on_carpet(field, p_F)) return kBlack;
  const auto line = nearest_line(field, p_F);
  return line && std::abs(line->distance) < 0.5 * field.line_width ? kWhite : kGreen;
}

inline Paint look(const CameraModel& model,
                  const FieldModel& field,
                  const Scene& scene,
                  Pixel pixel) {
  const auto ray = model.ray(pixel);
  return ray ? look(*ray, field, scene) : kBlack;
}

// The mean of nine rays through a pixel: edges must be grey to be found well.
inline Paint pixel_of(const CameraModel& model,
                      const FieldModel& field,
                      const Scene& scene,
                      Pixel pixel) {
  Paint sum{0, 0, 0};
  for (const double du : {-1.0 / 3.0, 0.0, 1.0 / 3.0}) {
    for (const double dv : {-1.0 / 3.0, 0.0, 1.0 / 3.0}) {
      const Paint paint = look(model, field, scene, {pixel.u + du, pixel.v + dv});
      sum = {sum.y + paint.y, sum.u + paint.u, sum.v + paint.v};
    }
  }
  return {sum.y / 9, sum.u / 9, sum.v / 9};
}

inline std::vector<std::uint8_t> frame_of(const CameraParameters& camera,
                                          const FieldModel& field,
                                          const Scene& scene) {
  const CameraModel model(camera);
  const bool is_small = camera.width_px == kWidth;  // of many pixels one ray each is enough
  std::vector<std::uint8_t> bytes;
  for (std::uint32_t v = 0; v < camera.height_px; ++v) {
    for (std::uint32_t u = 0; u < camera.width_px; ++u) {
      const Pixel pixel{1.0 * u, 1.0 * v};
      const Paint paint =
          is_small ? pixel_of(model, field, scene, pixel) : look(model, field, scene, pixel);
      bytes.push_back(static_cast<std::uint8_t>(paint.y));
      bytes.push_back(static_cast<std::uint8_t>(u % 2 == 0 ? paint.u : paint.v));
    }
  }
  return bytes;
}

inline ImageView view_of(const std::vector<std::uint8_t>& bytes) {
  return {bytes, kWidth, kHeight, PixelFormat::kYuyv};
}

// What a robot with this camera sees of the scene.
inline FrameObservation seen_of(const Scene& scene,
                                const CameraParameters& camera = small_camera()) {
  Perception perception(camera, test_field());
  const auto bytes = frame_of(camera, test_field(), scene);
  const auto seen = perception.see(view_of(bytes), {});
  return seen ? **seen : FrameObservation{};
}

// Between the ball's ray and the way to its middle; rad.
inline double error_of(const BallRay& ball, const Point3<Robot>& p_RB) {
  const Eigen::Vector3d way = p_RB.vector() - ball.ray_R.origin.vector();
  return std::acos(ball.ray_R.direction.dot(way.normalized()));
}

}  // namespace teamsight::vision
