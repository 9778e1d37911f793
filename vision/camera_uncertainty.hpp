// vision/camera_uncertainty.hpp: how well the camera model knows what it says.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "geometry/frames.hpp"
#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// A pixel's ray with the covariance of its direction.
struct UncertainRay {
  Ray<Robot> ray;
  /// Of (elevation, azimuth): up, and counter-clockwise times the cosine of the elevation; rad^2.
  Eigen::Matrix2d cov{Eigen::Matrix2d::Zero()};
};

/// A place on a horizontal plane.
struct UncertainPlace {
  Point<Robot> p_R;
  Eigen::Matrix2d cov_R{Eigen::Matrix2d::Zero()};  ///< m^2
};

/// A place in the picture.
struct UncertainPixel {
  Pixel pixel;
  Eigen::Matrix2d cov_px{Eigen::Matrix2d::Zero()};  ///< of (u, v); px^2
};

/// CameraModel's answers with their covariance: of the pixel, and, where the camera file says how
/// well it was calibrated, of the calibration. First order, by central differences.
///
/// The errors that come from the calibration are the same in every frame: they are no noise that
/// averages out. For offline use and tables, not for each pixel of each frame.
class CameraUncertainty {
 public:
  /// @pre as CameraModel; the calibration record was checked by settings::load_camera
  explicit CameraUncertainty(const CameraParameters& parameters);

  /// @param sigma_px  of the pixel in either direction
  /// @return nothing where the pixel, or one beside it, looks beside the mirror; the same below
  [[nodiscard]] std::optional<UncertainRay> ray(const Pixel& pixel, double sigma_px) const;

  /// On the horizontal plane at `height`: 0 is the floor, the ball's radius the plane of its
  /// centre.
  [[nodiscard]] std::optional<UncertainPlace> on_plane(const Pixel& pixel,
                                                       double height,
                                                       double sigma_px) const;

  /// Where a point in space appears.
  ///
  /// @param cov_R  of the point; m^2
  [[nodiscard]] std::optional<UncertainPixel> project(const Point3<Robot>& p_R,
                                                      const Eigen::Matrix3d& cov_R) const;

  [[nodiscard]] const CameraModel& model() const { return model_; }

 private:
  template <class Look>
  [[nodiscard]] std::optional<Eigen::Matrix2d> calibration_cov(const Look& look) const;

  CameraModel model_;
  std::vector<std::pair<CameraModel, CameraModel>> nudged_;  // of each knob: forwards, backwards
  Eigen::MatrixXd cov_nudges_;                               // of the knobs, in nudges
};

}  // namespace teamsight::vision
