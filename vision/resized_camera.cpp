// vision/resized_camera.cpp: places and lengths in pixels, scaled.
#include "vision/resized_camera.hpp"

#include <algorithm>
#include <variant>

namespace teamsight::vision {

namespace {

/// From old pixels to new ones, about both pictures' middles.
struct Scaling {
  double scale{1.0};
  double from_u{0.0};
  double from_v{0.0};
  double to_u{0.0};
  double to_v{0.0};

  [[nodiscard]] double u(double old) const { return to_u + scale * (old - from_u); }

  [[nodiscard]] double v(double old) const { return to_v + scale * (old - from_v); }

  void apply(Polygon& polygon) const {
    for (Corner& corner : polygon) corner = {u(corner.u), v(corner.v)};
  }

  void operator()(RadialTable& table) const {
    table.centre_u_px = u(table.centre_u_px);
    table.centre_v_px = v(table.centre_v_px);
    for (RingMark& row : table.rows) row.radius_px *= scale;
  }

  void operator()(ProfileMirror& mirror) const {
    mirror.centre_u_px = u(mirror.centre_u_px);
    mirror.centre_v_px = v(mirror.centre_v_px);
    mirror.focal_x_px *= scale;
    mirror.focal_y_px *= scale;
  }
};

}  // namespace

CameraParameters resized(const CameraParameters& camera,
                         std::uint32_t width_px,
                         std::uint32_t height_px) {
  const Scaling scaling{
      std::min(1.0 * width_px / camera.width_px, 1.0 * height_px / camera.height_px),
      0.5 * (camera.width_px - 1.0),
      0.5 * (camera.height_px - 1.0),
      0.5 * (width_px - 1.0),
      0.5 * (height_px - 1.0)};
  CameraParameters other = camera;
  other.width_px = width_px;
  other.height_px = height_px;
  std::visit(scaling, other.mirror);
  other.mask.inner_radius_px *= scaling.scale;
  other.mask.outer_radius_px *= scaling.scale;
  for (Polygon& polygon : other.mask.polygons) scaling.apply(polygon);
  for (SensorWindows& sensor : other.sensors) {
    for (Polygon& window : sensor.windows) scaling.apply(window);
  }
  other.calibration.reset();
  return other;
}

}  // namespace teamsight::vision
