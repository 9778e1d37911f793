// bench/peers/solo_ball.hpp: the ball as one robot alone tracks it, which the peers' rules choose
// from.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "fusion/observation.hpp"
#include "fusion/planar_filter.hpp"

namespace teamsight::peers {

/// A ball on the floor at one moment.
struct BallGuess {
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};  ///< m
  Eigen::Vector2d v_F{Eigen::Vector2d::Zero()};  ///< m/s
};

/// CAMBADA's: a constant-velocity Kalman filter on floor points, whose standard deviation grows
/// with the distance d as 0.01 d^2 - 0.01 d + 0.039 m; begun anew after 3 outliers in a row. Of
/// several balls in a frame, the one nearest to the prediction.
class SoloBall {
 public:
  void take(const fusion::Observation& observation, double t, double ball_radius);

  [[nodiscard]] bool has_ball() const { return has_ball_; }

  [[nodiscard]] double last_seen() const { return last_seen_; }  ///< s

  [[nodiscard]] double distance() const { return distance_; }  ///< m from the robot, when last seen

  /// Where the robot was then; m in F.
  [[nodiscard]] Eigen::Vector2d observer() const { return observer_F_; }

  /// Where it was when last seen.
  [[nodiscard]] BallGuess guess() const;

  /// Of the position when last seen; m^2.
  [[nodiscard]] double variance() const;

 private:
  [[nodiscard]] std::optional<Eigen::Vector2d> choose(const fusion::Observation& observation,
                                                      double t,
                                                      double ball_radius) const;
  void restart(const Eigen::Vector2d& p_F, double sigma);

  fusion::PlanarMoments moments_;
  bool has_ball_{false};
  int outliers_{0};
  double time_{0.0};
  double last_seen_{-1e9};
  double distance_{0.0};
  Eigen::Vector2d observer_F_{Eigen::Vector2d::Zero()};
};

}  // namespace teamsight::peers
