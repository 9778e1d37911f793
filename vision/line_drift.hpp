// vision/line_drift.hpp: whether the line points still lie where a calibrated camera would put
// them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.hpp"
#include "vision/camera_model.hpp"
#include "vision/line_map.hpp"
#include "vision/line_points.hpp"
#include "vision/ray_table.hpp"

namespace teamsight::vision {

/// What one frame's line points say of an error of the camera's map: a picture that is too large
/// and one that is shifted, which makes the radial residual a constant plus one wave around the
/// robot. Normal equations of (too large, shifted right, shifted up), in px, after the posture has
/// taken up what it can.
struct DriftEvidence {
  Eigen::Matrix3d info{Eigen::Matrix3d::Zero()};    ///< 1 / px^2
  Eigen::Vector3d vector{Eigen::Vector3d::Zero()};  ///< info * estimate
  std::uint16_t points{0};                          ///< that it comes from
};

/// What the evidence needs of a camera.
struct DriftGeometry {
  const RayTable* rays{nullptr};
  Pixel centre;
  bool mirrored{false};
};

/// Looks at one frame's line points under its fitted posture.
///
/// @param fits  which points count, by index; others have nothing to do with the paint
/// @return no points if there are too few to tell anything
[[nodiscard]] DriftEvidence drift_evidence(std::span<const LinePoint> points,
                                           const std::vector<bool>& fits,
                                           const LineMap& map,
                                           const Pose<Field, Robot>& X_FR,
                                           const DriftGeometry& geometry);

struct DriftRules {
  /// An error that is smaller raises no alarm, and what one frame knows worse does not count.
  double limit_px{1.0};
  double confidence{0.9999};  ///< that it is not chance
  double memory{60.0};        ///< frames at different places after which old ones fade
  double apart{0.25};  ///< m, or rad: frames nearer than this to the last one tell nothing new
};

/// What is believed of the calibration.
struct DriftReport {
  double drift_px{0.0};  ///< RMS radial error around the robot; 0: nothing known yet
  double size_px{0.0};   ///< the picture is larger than the camera file says, if positive
  Eigen::Vector2d shift_px{0.0, 0.0};  ///< of the picture, to the right and up
  bool alarm{false};                   ///< the calibration no longer holds
};

/// Watches the evidence of many frames.
///
/// Frames are taken at different places only, and of each what it can tell: a frame that shows one
/// line counts for the one or two directions that this line measures. How much the estimates
/// scatter widens the test, so that paint which lies a little off, or noise that is not white,
/// raises no alarm. Once raised, an alarm stays until the error is under 0.7 of the limit. A value;
/// no clock.
class DriftWatch {
 public:
  explicit DriftWatch(const DriftRules& rules = {}) : rules_(rules) {}

  /// @param X_FR  the posture that the evidence was made with
  void take(const DriftEvidence& evidence, const Pose<Field, Robot>& X_FR);

  [[nodiscard]] const DriftReport& report() const { return report_; }

 private:
  [[nodiscard]] bool is_elsewhere(const Pose<Field, Robot>& X_FR) const;
  void judge();

  DriftRules rules_;
  Eigen::Matrix3d info_{Eigen::Matrix3d::Zero()};
  Eigen::Vector3d vector_{Eigen::Vector3d::Zero()};
  double square_{0.0};  // sum of estimate' info estimate of the frames
  double told_{0.0};    // faded count of the directions that frames told
  std::optional<Pose<Field, Robot>> last_;
  DriftReport report_;
};

}  // namespace teamsight::vision
