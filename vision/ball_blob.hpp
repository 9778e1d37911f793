// vision/ball_blob.hpp: sums over the pixels of a blob, and the ellipse they make.
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace teamsight::vision {

/// What a blob's pixels add up to.
struct BallBlob {
  std::size_t pixels{0};
  double solid_angle{0.0};  ///< sr
  double sum_u{0.0};        ///< px
  double sum_v{0.0};
  double sum_uu{0.0};
  double sum_uv{0.0};
  double sum_vv{0.0};
  double sum_u_chroma{0.0};
  double sum_v_chroma{0.0};
  Eigen::Vector3d sum_direction{Eigen::Vector3d::Zero()};  ///< in R, weighted by solid angle
  Eigen::Vector3d sum_origin{Eigen::Vector3d::Zero()};     ///< of the rays, in R; the same
  Eigen::Matrix3d sum_square{Eigen::Matrix3d::Zero()};     ///< of the directions; the same

  BallBlob& operator+=(const BallBlob& other);
};

/// The ellipse with a blob's second moments; px.
struct BlobEllipse {
  double u{0.0};
  double v{0.0};
  double major{0.0};      ///< half axis
  double minor{0.0};      ///< half axis
  double direction{0.0};  ///< of the major axis, clockwise from image right; rad
};

/// @pre the blob has pixels
[[nodiscard]] BlobEllipse ellipse_of(const BallBlob& blob);

/// Half the angle that a blob fills along the longer of its axes, as a disc would; rad. What shades
/// or hides one side of a ball leaves its extent across that whole. 0: a single pixel.
[[nodiscard]] double angular_extent_of(const BallBlob& blob);

/// 1 for a disc as the eye sees it, towards 0 for a streak: the smaller over the larger spread of
/// the directions.
[[nodiscard]] double roundness_of(const BallBlob& blob);

}  // namespace teamsight::vision
