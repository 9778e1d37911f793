// tests/vision/calibration/bent_camera.hpp: a mirror camera with defects, traced by other means.
#pragma once

#include <optional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_model.hpp"
#include "geometry/pose.hpp"
#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// What is wrong with one robot's camera; numbers mean what the fields of ProfileMirror mean.
struct Defects {
  double focal_ratio{0.0};
  Eigen::Vector2d centre_px{0.0, 0.0};
  Eigen::Vector3d offset_m{0.0, 0.0, 0.0};
  Eigen::Vector2d tilt_rad{0.0, 0.0};
  Eigen::Vector2d head_rad{0.0, 0.0};  // roll, pitch
  double height_m{0.0};
};

/// Up to 0.5 mm of offset in each direction, 0.3 degrees of each tilt, 1 % of focal length.
[[nodiscard]] Defects random_defects(std::mt19937& random);

/// The camera that its file describes: no defects. A hyperbolic mirror of closed form, sampled.
[[nodiscard]] CameraParameters drawn_camera();

/// Traces rays with the mirror's closed form as an implicit surface: bisection and numerical
/// normals, all in R. Shares no code with vision's camera model; only the meaning of the defects.
class BentCamera {
 public:
  explicit BentCamera(const Defects& defects);

  /// Where the pixel meets the floor; m in R.
  [[nodiscard]] std::optional<Eigen::Vector2d> floor_at(const Eigen::Vector2d& pixel) const;

  /// The pixel that shows a place on the floor.
  [[nodiscard]] std::optional<Eigen::Vector2d> pixel_of(const Eigen::Vector2d& p_R) const;

 private:
  [[nodiscard]] double above_mirror(const Eigen::Vector3d& p_R) const;

  double focal_;
  Eigen::Vector2d centre_;
  Eigen::Matrix3d axes_C_;  // columns: C's axes in R
  Eigen::Vector3d pinhole_;
  Eigen::Matrix3d axes_M_;  // columns: the mirror's axes in R
  Eigen::Vector3d apex_;
};

/// How a view of lines is made.
struct LineSight {
  double range{7.0};      ///< m
  double sigma_px{0.15};  ///< of each pixel in each direction
  double outliers{0.03};
  double spacing{0.25};  ///< m along the paint
};

/// The line pixels that a robot at X_FR sees, except in one random sector of 0.6 rad.
[[nodiscard]] std::vector<Pixel> see_lines(const BentCamera& camera,
                                           const FieldModel& field,
                                           const Pose<Field, Robot>& X_FR,
                                           const LineSight& sight,
                                           std::mt19937& random);

/// RMS over the floor from 1 m to 6 m of what `model` says against what is; m.
[[nodiscard]] double ground_error(const BentCamera& camera, const CameraModel& model);

}  // namespace teamsight::vision
