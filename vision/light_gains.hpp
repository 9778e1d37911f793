// vision/light_gains.hpp: one light against another: how much more red, green and blue a sensor
// shows of the same thing.
#pragma once

#include <Eigen/Core>

#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// What a colour's red, green and blue are multiplied by; 1 is the camera file's light.
struct LightGains {
  double red{1.0};
  double green{1.0};
  double blue{1.0};

  friend bool operator==(const LightGains&, const LightGains&) = default;
};

/// How much brighter grey is.
[[nodiscard]] constexpr double exposure_of(const LightGains& gains) {
  return 0.299 * gains.red + 0.587 * gains.green + 0.114 * gains.blue;
}

/// Red, green, blue of BT.601 full range; not clamped.
[[nodiscard]] inline Eigen::Vector3d rgb_of(double y, double u, double v) {
  const double cb = u - 128.0;
  const double cr = v - 128.0;
  return {y + 1.402 * cr, y - 0.344136 * cb - 0.714136 * cr, y + 1.772 * cb};
}

/// Luminance and chroma as the difference from grey, of red, green and blue.
[[nodiscard]] inline Eigen::Matrix3d yuv_from_rgb() {
  return (Eigen::Matrix3d() << 0.299,
          0.587,
          0.114,  //
          -0.168736,
          -0.331264,
          0.5,  //
          0.5,
          -0.418688,
          -0.081312)
      .finished();
}

}  // namespace teamsight::vision
