// fusion/ball_motion.cpp: see fusion/ball_motion.hpp.
#include "fusion/ball_motion.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::fusion {
namespace {

/// White acceleration in the axes that are free.
BallMatrix white_acceleration(double dt, double psd, const Eigen::Vector3d& axes) {
  BallMatrix disturbance = BallMatrix::Zero();
  const Eigen::Matrix3d one = (psd * axes).asDiagonal();
  disturbance << one * (dt * dt * dt / 3.0), one * (dt * dt / 2.0), one * (dt * dt / 2.0), one * dt;
  return disturbance;
}

}  // namespace

BallStep step_rolling(const BallVector& mean, double dt, double psd, const BallMotion& motion) {
  const double speed = mean.segment<2>(3).norm();
  const double braked = motion.friction * dt;
  // Below a speed that it may or may not have, friction has no direction.
  const double kept = speed > 1e-6 ? std::max(0.0, 1.0 - braked / speed) : 0.0;
  BallStep step;
  step.mean = mean;
  step.mean.head<2>() += 0.5 * (1.0 + kept) * dt * mean.segment<2>(3);
  step.mean.segment<2>(3) *= kept;
  step.mean(2) = motion.radius;
  step.mean(5) = 0.0;
  step.transition.setIdentity();
  step.transition(0, 3) = step.transition(1, 4) = dt;
  step.transition.row(2).setZero();
  step.transition.row(5).setZero();
  step.disturbance = white_acceleration(dt, psd, {1.0, 1.0, 0.0});
  step.disturbance(2, 2) = motion.sigma_floor * motion.sigma_floor;
  step.disturbance(5, 5) = motion.sigma_floor * motion.sigma_floor;
  return step;
}

BallStep step_led(const BallVector& mean, double dt, const BallMotion& motion) {
  BallMotion unbraked = motion;
  unbraked.friction = 0.0;
  return step_rolling(mean, dt, motion.led_psd, unbraked);
}

BallMatrix led_for_a_part(double dt, const BallMotion& motion) {
  // The mean of white_acceleration over [0, dt].
  const Eigen::Matrix3d one = motion.led_psd * Eigen::Vector3d(1.0, 1.0, 0.0).asDiagonal();
  BallMatrix added;
  added << one * (dt * dt * dt / 12.0), one * (dt * dt / 6.0), one * (dt * dt / 6.0),
      one * (dt / 2.0);
  return added;
}

BallStep step_flying(const BallVector& mean, double dt, const BallMotion& motion) {
  BallStep step;
  const double braked = motion.drag * mean.tail<3>().norm() * dt;
  step.mean = mean;
  step.mean.head<3>() += dt * mean.tail<3>();
  step.mean(2) -= 0.5 * motion.gravity * dt * dt;
  step.mean.tail<3>() *= std::max(0.0, 1.0 - braked);
  step.mean(5) -= motion.gravity * dt;
  step.transition.setIdentity();
  step.transition.topRightCorner<3, 3>() = dt * Eigen::Matrix3d::Identity();
  step.disturbance = white_acceleration(dt, motion.flying_psd, {1.0, 1.0, 1.0});
  if (step.mean(2) >= motion.radius || step.mean(5) >= 0.0) return step;
  const double doubt = motion.bounce_doubt * step.mean.tail<3>().norm();
  BallVector kept = BallVector::Ones();
  kept(2) = kept(5) = -motion.climb_kept;
  kept(3) = kept(4) = motion.speed_kept;
  step.mean(2) -= motion.radius;
  step.mean = kept.asDiagonal() * step.mean;
  step.mean(2) += motion.radius;
  step.lands = step.mean(5) < motion.least_climb;
  step.transition = kept.asDiagonal() * step.transition;
  step.disturbance.bottomRightCorner<3, 3>() += doubt * doubt * Eigen::Matrix3d::Identity();
  return step;
}

std::optional<BallStep> step_rebound(const BallVector& mean, const BallMotion& motion) {
  const Eigen::Vector2d from_centre = mean.head<2>() - motion.carpet_centre;
  const Eigen::Vector2d kept =
      from_centre.cwiseMax(-motion.carpet_reach).cwiseMin(motion.carpet_reach);
  if (kept == from_centre) return std::nullopt;
  BallStep step;
  step.mean = mean;
  step.mean.head<2>() = motion.carpet_centre + kept;
  step.transition.setIdentity();
  const double doubt = motion.rebound_doubt * mean.segment<2>(3).norm();
  step.disturbance.setZero();
  step.disturbance(3, 3) = step.disturbance(4, 4) = doubt * doubt;
  for (const int axis : {0, 1}) {
    const bool goes_out = (from_centre(axis) - kept(axis)) * mean(3 + axis) > 0.0;
    if (!goes_out) continue;
    step.transition(3 + axis, 3 + axis) = -motion.rebound_kept;
    step.mean(3 + axis) *= -motion.rebound_kept;
  }
  return step;
}

BallStep step_kicked(const BallVector& mean,
                     double dt,
                     const Kick& kick,
                     const BallMotion& motion) {
  // Of a normal distribution's half beyond a line through its middle, in standard deviations.
  constexpr double kMeanOfHalf = 0.79788456;  // sqrt(2 / pi)
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  velocity.head<2>() = kMeanOfHalf * kick.sigma * kick.away;
  const double var = kick.sigma * kick.sigma;
  Eigen::Matrix3d spread = Eigen::Vector3d(var, var, 0.0).asDiagonal();
  spread -= velocity * velocity.transpose();
  if (kick.into == BallMode::kFlying) {
    velocity.z() = motion.climb;
    spread(2, 2) = motion.sigma_climb * motion.sigma_climb;
  }
  BallStep step;
  step.transition.setZero();
  step.transition.topLeftCorner<3, 3>().setIdentity();
  step.mean.head<3>() = mean.head<3>() + 0.5 * dt * (velocity - mean.tail<3>());
  step.mean.tail<3>() = velocity;
  const Eigen::Vector3d changed = mean.tail<3>() - velocity;
  const Eigen::Matrix3d instant = changed.cwiseAbs2().asDiagonal();
  step.disturbance << dt * dt * (spread / 3.0 + instant / 12.0), 0.5 * dt * spread,
      0.5 * dt * spread, spread;
  return step;
}

}  // namespace teamsight::fusion
