// bench/fuse_score/bound.hpp: how well the ball could be known at best.
#pragma once

#include <Eigen/Core>

#include "bench/play/play_log.hpp"

namespace teamsight::score {

/// What the best estimator could know of the first ball at one moment.
struct BallBound {
  bool is_known{false};      ///< position within half a metre
  double var_position{0.0};  ///< trace over x, y and, in flight, z; m^2
  double var_velocity{0.0};  ///< likewise
};

/// The posterior Cramer-Rao bound [Tichavsky98] over the frames that were delivered: recursion of
/// the joint covariance of ball, posture errors, calibration and slow errors of every robot,
/// linearised at the truth; heavy-tailed noise by its Fisher information. It is told when the ball
/// is kicked or bounces, whether it flies, and which report is no phantom; no estimator is.
class BoundFilter {
 public:
  explicit BoundFilter(const play::PlayLog& log);

  /// Goes on to the exposure of a delivered frame and takes it in.
  void take(const play::Frame& frame);

  /// The bound at `t`, at or after the last frame's exposure.
  [[nodiscard]] BallBound at(double t) const;

 private:
  static constexpr int kBall = 6;
  static constexpr int kPerRobot =
      7;  // x, y, theta, scale, azimuth offset, slow azimuth, elevation
  using Matrix = Eigen::MatrixXd;

  void predict(double t);
  void step_ball();
  void forget(int first, int count, double var);
  void add(const Eigen::RowVectorXd& slope, double var);

  [[nodiscard]] int column(int robot) const { return kBall + kPerRobot * robot; }

  void add_ray(const play::Frame& frame);

  const play::PlayLog* log_;
  double time_{0.0};
  Matrix cov_;
  Matrix stationary_;
};

}  // namespace teamsight::score
