// tests/sim/render/eyes.hpp: cameras below mirrors of simple shape.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "vision/camera_parameters.hpp"

namespace teamsight::sim {

inline constexpr double kFocal = 400.0;        // px
inline constexpr double kPinholeHeight = 0.6;  // m
inline constexpr double kRim = 0.09;           // m

/// 640x480, centre (320, 240), forward is up in the picture; `height` gives y over x.
inline vision::CameraParameters eye_below(const std::function<double(double)>& height,
                                          int points = 600) {
  vision::ProfileMirror mirror;
  mirror.focal_x_px = kFocal;
  mirror.focal_y_px = kFocal;
  mirror.centre_u_px = 320.0;
  mirror.centre_v_px = 240.0;
  mirror.pinhole_height = kPinholeHeight;
  for (int i = 0; i <= points; ++i) {
    const double x = kRim * i / points;
    mirror.profile.push_back({x, height(x)});
  }
  vision::CameraParameters camera;
  camera.width_px = 640;
  camera.height_px = 480;
  camera.format = vision::PixelFormat::kBgr;
  camera.mirror = mirror;
  camera.forward = std::numbers::pi / 2.0;
  camera.mirrored = true;
  return camera;
}

inline vision::ProfileMirror& mirror_of(vision::CameraParameters& camera) {
  return std::get<vision::ProfileMirror>(camera.mirror);
}

inline double plane(double /*x*/) {
  return 0.15;
}

inline double cone(double x) {
  return 0.12 + 0.55 * x;
}

/// Radius 0.1 m, lowest point 0.12 m over the pinhole.
inline double sphere(double x) {
  return 0.22 - std::sqrt(0.01 - x * x);
}

}  // namespace teamsight::sim
