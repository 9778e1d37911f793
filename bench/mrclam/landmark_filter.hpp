// bench/mrclam/landmark_filter.hpp: one robot's own posture from wheels and known landmarks.
#pragma once

#include <Eigen/Core>

#include "bench/mrclam/robot_logs.hpp"

namespace teamsight::mrclam {

/// How wrong the robots' senses are taken to be. Errors of one landmark last from frame to frame,
/// so that more is assumed than the scatter on this data set (range 13 cm, bearing 9 mrad): about
/// what makes the filter's own covariance true.
struct SenseErrors {
  double sigma_range{0.25};     ///< m
  double sigma_bearing{0.05};   ///< rad
  double sigma_forward{0.05};   ///< m after a second, of the wheels
  double sigma_sideways{0.02};  ///< m after a second
  double sigma_turn{0.1};       ///< rad after a second
  double gate{13.8};            ///< squared, in standard deviations; 99.9 %
};

/// An extended Kalman filter over (x, y, theta), as every robot could run it alone.
class LandmarkFilter {
 public:
  LandmarkFilter(const SenseErrors& errors, const Pose<Field, Robot>& start);

  /// Goes on by `dt` (s) with what the wheels say.
  void roll(const Wheels& wheels, double dt);

  /// A landmark at `p_F`; left out if it does not fit.
  void look(const Seen& seen, const Eigen::Vector2d& p_F);

  [[nodiscard]] const Eigen::Vector3d& mean() const { return mean_; }

  [[nodiscard]] const Eigen::Matrix3d& cov() const { return cov_; }

 private:
  SenseErrors errors_;
  Eigen::Vector3d mean_;
  Eigen::Matrix3d cov_;
};

}  // namespace teamsight::mrclam
