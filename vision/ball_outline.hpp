// vision/ball_outline.hpp: a ball's direction and size by the part of its outline that is seen.
#pragma once

#include <cstddef>
#include <optional>

#include <Eigen/Core>

#include "geometry/frames.hpp"
#include "vision/ray_table.hpp"

namespace teamsight::vision {

/// What the pixels of a blob's outline add up to, without those where the view itself ends.
struct BallOutline {
  std::size_t pixels{0};
  std::size_t cut{0};  ///< pixels where the view ends; not in the sums
  Eigen::Vector3d sum_direction{Eigen::Vector3d::Zero()};  ///< in R
  Eigen::Matrix3d sum_square{Eigen::Matrix3d::Zero()};     ///< of the directions
  Eigen::Vector3d sum_across{Eigen::Vector3d::Zero()};     ///< of the origins across their rays; m

  void add(const PixelRay& ray);
  BallOutline& operator+=(const BallOutline& other);
};

/// The cone that touches a ball all around.
struct BallCone {
  Ray<Robot> axis_R;           ///< from the point that the outline's rays pass most nearly
  double angular_radius{0.0};  ///< rad
  double sigma{0.0};           ///< of the outline's pixels about the cone; rad
};

/// The cone through the directions of an outline, by least squares: an arc of it is enough.
///
/// @return nothing if there are too few pixels
[[nodiscard]] std::optional<BallCone> cone_of(const BallOutline& outline);

/// The angular radius of a ball on the floor that is seen along that ray; rad. 0: none can be.
[[nodiscard]] double angular_radius_on_floor(const Ray<Robot>& ray_R, double ball_radius);

}  // namespace teamsight::vision
