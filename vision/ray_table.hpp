// vision/ray_table.hpp: what every pixel looks along, worked out once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// One pixel's view; single precision, because a camera has a million of them.
struct PixelRay {
  float origin_x{0.0F};  ///< on the mirror, in R; m
  float origin_y{0.0F};
  float origin_z{0.0F};
  float direction_x{0.0F};  ///< unit length, in R; all three 0: the pixel sees nothing
  float direction_y{0.0F};
  float direction_z{0.0F};
  float floor_x{0.0F};  ///< where it meets the floor, in R; m; not a number: it does not
  float floor_y{0.0F};
  float radial_footprint{0.0F};      ///< metres of floor per pixel, away from the robot
  float tangential_footprint{0.0F};  ///< metres of floor per pixel, around the robot

  [[nodiscard]] bool sees_something() const {
    return direction_x != 0.0F || direction_y != 0.0F || direction_z != 0.0F;
  }

  [[nodiscard]] bool sees_floor() const { return floor_x == floor_x; }
};

/// The rays of all pixels of a camera.
class RayTable {
 public:
  /// Takes some 0.1 us per pixel of a radial table, 0.4 us of a traced mirror.
  RayTable(const CameraModel& model, std::uint32_t width_px, std::uint32_t height_px);

  /// @pre u < width, v < height
  [[nodiscard]] const PixelRay& at(std::uint32_t u, std::uint32_t v) const {
    return rays_[std::size_t{v} * width_ + u];
  }

  /// By row * width + column.
  [[nodiscard]] const PixelRay& operator[](std::size_t pixel) const { return rays_[pixel]; }

  [[nodiscard]] std::uint32_t width() const { return width_; }

  [[nodiscard]] std::uint32_t height() const { return height_; }

 private:
  /// How the floor point moves from one pixel to the next, to the right or downwards; m.
  [[nodiscard]] Eigen::Vector2f step_along_u(std::uint32_t u, std::uint32_t v) const;
  [[nodiscard]] Eigen::Vector2f step_along_v(std::uint32_t u, std::uint32_t v) const;

  std::uint32_t width_;
  std::uint32_t height_;
  std::vector<PixelRay> rays_;
};

/// The mean height over the floor from which the pixels look that see floor; m.
///
/// @return nothing if no pixel sees floor
[[nodiscard]] std::optional<double> eye_height(const RayTable& rays);

/// The solid angle that a pixel covers: the parallelogram of its neighbours' directions; sr.
///
/// @pre u < width, v < height
/// @return 0 in the last row and column, and where the mirror ends
[[nodiscard]] float solid_angle_of(const RayTable& rays, std::uint32_t u, std::uint32_t v);

}  // namespace teamsight::vision
