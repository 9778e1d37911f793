// vision/local_view.hpp: the picture around a pixel as angles.
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "vision/camera_model.hpp"
#include "vision/ray_table.hpp"

namespace teamsight::vision {

/// Around one pixel, how steps in the picture and angles between rays belong together: what looks
/// round is a disc in angles, however a mirror draws it out.
struct LocalView {
  Pixel middle;
  Eigen::Matrix2d to_angles;  ///< of a step (u, v) in px; rad, along two directions at right angles
  Eigen::Matrix2d to_pixels;  ///< the inverse

  /// The pixel that lies so far from the middle; it may be outside the image.
  [[nodiscard]] Pixel pixel(const Eigen::Vector2d& angles) const {
    const Eigen::Vector2d step = to_pixels * angles;
    return {middle.u + step.x(), middle.v + step.y()};
  }
};

/// Rows and columns of an image, from the first to behind the last.
struct PixelBox {
  std::uint32_t first_row{0};
  std::uint32_t end_row{0};
  std::uint32_t first_column{0};
  std::uint32_t end_column{0};
};

/// The smallest box that holds all pixels of a disc, as far as they lie in the image.
///
/// @param radius  rad
[[nodiscard]] PixelBox box_around(const LocalView& view, double radius, const RayTable& rays);

/// @param span  px, to both sides of the pixel: over how much the picture's scale is taken
/// @return nothing where the camera sees nothing on one of the sides
[[nodiscard]] std::optional<LocalView> view_around(const RayTable& rays,
                                                   const Pixel& middle,
                                                   double span);

}  // namespace teamsight::vision
