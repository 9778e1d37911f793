// vision/calibration/line_calibration.hpp: a camera from pictures of lines at unknown places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/calibration/bundle.hpp"
#include "vision/camera_knobs.hpp"
#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/line_map.hpp"

namespace teamsight::vision {

struct LineCalibrationRules {
  BundleRules bundle;
  double reach{6.0};              ///< m of floor that the camera shall know
  double max_ground_sigma{0.02};  ///< m; known worse on average over that floor is not known
};

/// Why there is no calibration.
enum class LineRefusal : std::uint8_t {
  kNoPosture,      ///< no view's line points lie like this field's lines
  kDoesNotFit,     ///< the best camera leaves the points off the paint: another mirror or field
  kNotDetermined,  ///< the views leave the camera's knobs open
};

/// One knob before and after.
struct KnobResult {
  KnobPrior prior;
  double turn{0.0};
  double sigma{0.0};  ///< of the turn

  /// How much of what is known of it comes from the views; 0: nothing, it rests on its prior.
  [[nodiscard]] double share_of_views() const {
    return 1.0 - sigma * sigma / (prior.sigma * prior.sigma);
  }
};

/// One view before and after; misses are signed and of all its pixels that show floor.
struct ViewResult {
  bool used{false};  ///< false: its points fit nowhere on this field
  Pose<Field, Robot> X_FR;
  double inlier_ratio{0.0};
  std::vector<PaintMiss> before;  ///< with the posture that suits the camera it started with
  std::vector<PaintMiss> after;
};

struct LineCalibration {
  std::optional<LineRefusal> refusal;  ///< nothing: `camera` is good to use
  CameraParameters camera;             ///< with its CalibrationRecord
  std::vector<KnobResult> knobs;
  std::vector<ViewResult> views;  ///< as given
  double ground_sigma{0.0};       ///< m, RMS over the floor up to the reach, as predicted
  double scale{1.0};              ///< true sigma of the pixels over the claimed one
};

/// Finds the camera that explains the line pixels of all views, and where each was taken.
///
/// No measured places are needed: the postures come from a search over the whole field, then
/// postures and camera are fitted together (`adjust`). Views that fit nowhere are left out.
///
/// @param camera  near the real one: within the knobs' priors
/// @param pixels  of each view, on the middle of painted lines; outliers are expected
[[nodiscard]] LineCalibration calibrate_lines(const LineMap& map,
                                              const CameraParameters& camera,
                                              std::span<const std::vector<Pixel>> pixels,
                                              const LineCalibrationRules& rules);

/// The line pixels of each view, found through a camera. Where the picture shows the middle of the
/// paint depends on what one pixel means on the floor, and so on the camera.
///
/// @return every time the same views in the same order
using LineSource = std::function<std::vector<std::vector<Pixel>>(const CameraParameters&)>;

/// The same from pictures: the lines are found through `camera`, then again through the camera that
/// they gave, until it stays where it is.
[[nodiscard]] LineCalibration calibrate_lines(const LineMap& map,
                                              const CameraParameters& camera,
                                              const LineSource& lines,
                                              const LineCalibrationRules& rules);

/// Standard deviation on the floor that a calibration's covariance means, RMS over distances from
/// 1 m to `reach` all around; m. Twice a direction's: of the two-dimensional error.
///
/// @pre the camera has a calibration record
[[nodiscard]] double ground_sigma_of(const CameraParameters& camera, double reach);

/// Difference between what two cameras say of the same pixels, RMS over the floor from 1 m to
/// `reach` all around; m. @return nothing if they share no such floor
[[nodiscard]] std::optional<double> ground_difference(const CameraModel& truth,
                                                      const CameraModel& other,
                                                      double reach);

}  // namespace teamsight::vision
