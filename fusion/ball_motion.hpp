// fusion/ball_motion.hpp: the ways in which a ball moves, each as one step of a filter.
#pragma once

#include <array>

#include <Eigen/Core>

namespace teamsight::fusion {

/// (x, y, z, vx, vy, vz) of the ball's centre in F; m, m/s.
using BallVector = Eigen::Matrix<double, 6, 1>;
using BallMatrix = Eigen::Matrix<double, 6, 6>;

/// Rolling: alone on the floor. Kicked: just now pushed, on the floor, speed unknown. Flying.
enum class BallMode : int { kRolling, kKicked, kFlying };
inline constexpr int kBallModes = 3;

/// What balls do; SI.
struct BallMotion {
  double radius{0.11};        ///< m; it lies this high
  double friction{0.45};      ///< m/s^2 on carpet; middle of 0.3 to 0.6
  double rolling_psd{0.08};   ///< m^2/s^3: carpet is uneven
  double kicked_psd{8.0};     ///< m^2/s^3: while the foot is at it
  double flying_psd{0.3};     ///< m^2/s^3
  double gravity{9.81};       ///< m/s^2
  double drag{0.012};         ///< 1/m
  double climb_kept{0.65};    ///< of the vertical speed at a bounce
  double speed_kept{0.8};     ///< of the horizontal speed at a bounce
  double bounce_doubt{0.15};  ///< of the speed: what a bounce does besides
  double sigma_kick{4.0};     ///< m/s per floor component, of a kick's change of velocity
  double sigma_climb{3.5};    ///< m/s, of a kick's vertical speed
  double sigma_floor{0.01};   ///< m, of the height of one that rolls
  double kicks{0.7};          ///< per second, of a rolling ball
  double high_kicks{0.2};     ///< per second, of a rolling ball
  double kick_ends{6.0};      ///< per second
  double kick_rises{1.0};     ///< per second
  double landings{1.0};       ///< per second
};

/// One step of one mode: where the mean goes, how errors go, and what is added to them.
struct BallStep {
  BallVector mean;
  BallMatrix transition;
  BallMatrix disturbance;
};

/// @param dt  s, above 0
[[nodiscard]] BallStep step_rolling(const BallVector& mean,
                                    double dt,
                                    double psd,
                                    const BallMotion& motion);

/// Ballistic with drag; bounces where it would come through the floor.
[[nodiscard]] BallStep step_flying(const BallVector& mean, double dt, const BallMotion& motion);

/// Probability of going from one mode (row) to another (column) within dt.
[[nodiscard]] Eigen::Matrix3d mode_transitions(double dt, const BallMotion& motion);

}  // namespace teamsight::fusion
