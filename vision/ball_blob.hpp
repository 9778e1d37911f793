// vision/ball_blob.hpp: sums over the pixels of a blob, and the ellipse they make.
#pragma once

#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

#include "vision/ball_outline.hpp"

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
  std::uint8_t mirror_part{0};
  BallOutline outline;  ///< of a blob that ends where its part of the mirror ends; else empty

  /// @pre both lie in the same part of the mirror
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

/// Whether so much of a blob's outline lies where its part of the mirror ends that only the rest of
/// the outline says how large and where the ball is.
[[nodiscard]] bool is_cut(const BallBlob& blob);

/// @pre the blob has pixels
[[nodiscard]] BlobEllipse ellipse_of(const BallBlob& blob);

/// Half the angle that a blob fills along the longer of its axes, as a disc would; rad. What shades
/// or hides one side of a ball leaves its extent across that whole. 0: a single pixel.
[[nodiscard]] double angular_extent_of(const BallBlob& blob);

/// 1 for a disc as the eye sees it, towards 0 for a streak: the smaller over the larger spread of
/// the directions.
[[nodiscard]] double roundness_of(const BallBlob& blob);

}  // namespace teamsight::vision
