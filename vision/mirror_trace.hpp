// vision/mirror_trace.hpp: where a pinhole camera's line of sight goes after a mirror of known
// shape.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "geometry/frames.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/mirror_profile.hpp"

namespace teamsight::vision {

/// Turns the head (camera and mirror together) against R: first about x, then about y.
[[nodiscard]] Eigen::Matrix3d head_rotation(double roll, double pitch);

/// Traces lines of sight through a ProfileMirror.
class MirrorTrace {
 public:
  /// @param image_right  direction of C's x axis (image right) in R; rad
  /// @param flipped       the picture was turned over top to bottom before it came here, so that it
  ///                      is not the mirror image that an upward camera takes
  MirrorTrace(const ProfileMirror& mirror, double image_right, bool flipped);

  /// @param du, dv  pixel, from the image centre
  /// @return the reflected ray in R; nothing beside the mirror, or where it would hit it twice
  ///         from behind
  [[nodiscard]] std::optional<Ray<Robot>> trace(double du, double dv) const;

 private:
  /// Where a line of sight meets the mirror.
  struct Hit {
    Eigen::Vector3d p_M;
    Eigen::Vector3d normal_M;  // downwards or upwards, of length 1
  };

  [[nodiscard]] std::optional<Hit> hit(const Eigen::Vector3d& sight_M) const;

  MirrorProfile profile_;
  double focal_x_;
  double focal_y_;
  bool flipped_;
  Eigen::Matrix3d R_CM_;      // M: the mirror's design frame, apex on its z axis
  Eigen::Vector3d origin_M_;  // the pinhole
  Eigen::Matrix3d R_RM_;
  Eigen::Vector3d p_RC_;
  double apex_;  // height over the pinhole by design; m
};

}  // namespace teamsight::vision
