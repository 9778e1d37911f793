// bench/locate_score/spoils.hpp: what is done to the line points of a frame.
#pragma once

#include <functional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "bench/locate_score/line_view.hpp"
#include "geometry/pose.hpp"
#include "vision/line_points.hpp"

namespace teamsight::locate_score {

/// Changes the line points of one frame, given where the robot stands.
using Spoil =
    std::function<void(std::vector<vision::LinePoint>&, const Pose<Field, Robot>&, std::mt19937&)>;

/// Hides this share of the paint by chance: the whole of a metre or nothing of it.
[[nodiscard]] Spoil hide(double share);

/// Adds false points within 6 m until they are this share of all; each is as uncertain as a true
/// one so far out.
[[nodiscard]] Spoil falsify(double share);

/// A head that leans by 0.4 degrees (sigma) about each axis, as under acceleration.
///
/// @param eye_height  m
[[nodiscard]] Spoil lean(double eye_height);

/// What a calibration leaves of a robot's defects, as standard deviations; drawn once per robot.
struct CalibrationRemainder {
  double shift{0.002};  ///< of the robot in its own picture; m
  double turn{0.001};   ///< rad
  double scale{0.001};  ///< of ranges; dimensionless
  double bend{0.006};   ///< at 6 m; m
  double tilt{0.0005};  ///< of the head; rad
};

/// One robot's eye, as its calibration left it.
class Eye {
 public:
  Eye(const CalibrationRemainder& remainder, double eye_height, std::mt19937& random);

  /// Turns what a perfect eye sees into what this one does, up to 6 m.
  ///
  /// @param lean  of the head in this frame: roll, pitch; rad
  void look(std::vector<vision::LinePoint>& points,
            const Eigen::Vector2d& lean = Eigen::Vector2d::Zero()) const;

 private:
  MapFault fault_;
  Eigen::Vector2d tilt_;
  double eye_height_;
};

}  // namespace teamsight::locate_score
