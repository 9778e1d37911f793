// vision/colour_cube.hpp: every pixel of a frame to the nearest vertex of the RGB cube.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "vision/camera_parameters.hpp"
#include "vision/image.hpp"

namespace teamsight::vision {

/// Says on which side of three planes through colour space a colour lies: after an affine transform
/// that puts the cube's middle at the origin, the signs of red, green and blue name the nearest of
/// its eight vertices, as the founding paper segments.
///
/// A vertex is a number of three bits: 1 red, 2 green, 4 blue; so 0 is black, 3 yellow, 5 magenta,
/// 6 cyan and 7 white.
class ColourCube {
 public:
  /// Red, green and blue as seen from the cube's middle, in rows, of (y, u, v, 1); any unit.
  using Transform = Eigen::Matrix<double, 3, 4>;

  /// Weights are kept to sixteen bits: a plane may lie up to three grey levels off.
  ///
  /// @pre no row's weights of y, u and v are all 0
  explicit ColourCube(const Transform& from_yuv);

  /// Of a camera file's planes.
  ///
  /// @pre no plane's weights are all 0
  [[nodiscard]] static Transform transform_of(const std::array<CubePlane, 3>& planes);

  /// What a calibrated camera needs no more than: each of red, green and blue against a threshold.
  ///
  /// @param thresholds  of red, green and blue; grey levels
  [[nodiscard]] static Transform thresholds(const Eigen::Vector3d& thresholds);

  [[nodiscard]] std::uint8_t vertex(const SampledColour& colour) const {
    return vertex_of(yuv_, colour.y, colour.u, colour.v);
  }

  [[nodiscard]] std::uint8_t vertex_of_bgr(std::uint8_t b, std::uint8_t g, std::uint8_t r) const {
    return vertex_of(bgr_, b, g, r);
  }

  /// The vertex of every pixel, eight pixels at once where the format is YUYV, UYVY or BGR.
  ///
  /// @param vertices  one for each pixel, rows from top to bottom
  /// @pre is_whole(image)
  void segment(const ImageView& image, std::span<std::uint8_t> vertices) const;

  /// One row in fixed point: positive where the colour is bright; never beyond sixteen bits.
  struct Plane {
    std::array<std::int16_t, 3> weights{};
    std::int16_t offset{0};
  };

  /// Of red, green and blue.
  using Planes = std::array<Plane, 3>;

 private:
  static std::uint8_t vertex_of(const Planes& planes, int a, int b, int c) {
    unsigned vertex = 0;
    for (unsigned axis = 0; axis < planes.size(); ++axis) {
      const auto& [weights, offset] = planes[axis];
      const int value = weights[0] * a + weights[1] * b + weights[2] * c + offset;
      if (value > 0) vertex |= 1U << axis;
    }
    return static_cast<std::uint8_t>(vertex);
  }

  Planes yuv_;  // of y, u and v
  Planes bgr_;  // of blue, green and red
};

}  // namespace teamsight::vision
