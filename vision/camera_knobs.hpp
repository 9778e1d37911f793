// vision/camera_knobs.hpp: a camera's geometry as a vector of small turns, for calibration.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/camera_knob_names.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// A knob with what is known of it before anything is measured.
struct KnobPrior {
  CameraKnob knob{CameraKnob::kCentreU};
  double sigma{0.0};  ///< how far the real camera may be from its file; unit of the knob
};

/// The knobs of this kind of camera. Left out is what line points at unknown places cannot tell:
/// the mounting angle (every posture takes it up) and the height of a radial table's viewpoint
/// (only with the angles; on the floor it changes nothing).
[[nodiscard]] std::vector<KnobPrior> knobs_of(const CameraParameters& camera);

/// A step by which a knob's effect is measured, small against all that is not linear.
[[nodiscard]] double nudge_of(CameraKnob knob);

/// The camera with its knobs turned.
///
/// @param turn one value for each knob, in its unit
/// @pre the knobs belong to this kind of mirror
/// @return nothing if no such mirror can be: a radial table whose rows no longer grow, a focal
///         length or height that is not positive
[[nodiscard]] std::optional<CameraParameters> turned(const CameraParameters& camera,
                                                     std::span<const CameraKnob> knobs,
                                                     const Eigen::VectorXd& turn);

}  // namespace teamsight::vision
