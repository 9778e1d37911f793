// vision/calibration/bundle.hpp: one camera and the postures of all its views, fitted together.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.hpp"
#include "vision/camera_knobs.hpp"
#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/line_map.hpp"

namespace teamsight::vision {

/// What one image contributes: pixels on the middle of painted lines.
struct CalibrationView {
  std::vector<Pixel> pixels;
  Pose<Field, Robot> X_FR;  ///< where the robot stood; to start from, then as fitted
};

/// One pixel of a view against the paint.
struct PaintMiss {
  double distance{0.0};     ///< from the nearest paint; signed; m
  double distance_px{0.0};  ///< the same in the picture, across the paint
  double radial_px{0.0};    ///< share of it that points away from the image centre, signed outwards
  double direction{0.0};  ///< of the pixel in the picture, counter-clockwise from image right; rad
  double radius_px{0.0};
};

/// How the fit goes about it.
struct BundleRules {
  double sigma_px{0.3};      ///< of a line pixel, across the line; the true one is measured
  double max_distance{7.0};  ///< m; pixels that show floor farther away are left out
  /// What all line pixels of one distance from the image centre, of 10 px in width, may share: no
  /// scatter shows it and no number of views lessens it. The largest seen in rendered frames
  /// through the true camera is 0.06 px, where a mirror's floor scale ends.
  double shared_px{0.05};
};

/// Where the fit starts.
struct BundleStart {
  std::vector<CalibrationView> views;  ///< with postures within some 0.3 m and 10 degrees
  Eigen::VectorXd turn;                ///< of the knobs; empty: none
};

/// Where the fit ended.
struct Bundle {
  CameraParameters camera;
  std::vector<CalibrationView> views;
  Eigen::VectorXd turn;  ///< of the knobs, from the camera it started with
  Eigen::MatrixXd info;  ///< of the knobs from the views alone, postures marginalised
  /// Covariance of the gradient over the knobs that the pixels' shared errors mean, in the measure
  /// of `info` without `correlation`.
  Eigen::MatrixXd shared;
  double scale{1.0};        ///< true sigma of the pixels over the claimed one
  double correlation{1.0};  ///< how many neighbouring pixels count as one
  double cost{0.0};         ///< robust, at the end; ranks starts of the same views
  bool converged{false};
};

/// Turns the knobs and moves the robots until the line pixels lie on paint.
///
/// Levenberg-Marquardt on exact distances to the nearest paint, each weighted with what one pixel
/// means there; Geman-McClure weights annealed from 0.3 m; the postures are eliminated view by view
/// (Schur complement) [Triggs00]. The priors of the knobs hold what the field cannot see.
///
/// @param camera  to start from; the priors are centred on it
/// @pre at least one view and one knob
[[nodiscard]] Bundle adjust(const LineMap& map,
                            const CameraParameters& camera,
                            std::span<const KnobPrior> priors,
                            BundleStart start,
                            const BundleRules& rules);

/// How the pixels of a view miss the paint under a camera. Pixels that show no floor within reach
/// are left out.
[[nodiscard]] std::vector<PaintMiss> misses_of(const LineMap& map,
                                               const CameraModel& model,
                                               const CalibrationView& view,
                                               const BundleRules& rules);

}  // namespace teamsight::vision
