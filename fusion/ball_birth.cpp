// fusion/ball_birth.cpp: see fusion/ball_birth.hpp.
#include "fusion/ball_birth.hpp"

#include <algorithm>

#include "fusion/measurement.hpp"

namespace teamsight::fusion {
namespace {

/// With the place on the floor, and what is remembered of who saw it there.
Considered<6> placed(const BallBirth& birth) {
  const Candidate& candidate = birth.candidate;
  Considered<6> state;
  state.mean << candidate.measurement.p_F, birth.motion.radius, 0.0, 0.0, 0.0;
  state.cov.setZero();
  state.cov.diagonal().segment<2>(3).setConstant(birth.sigma_speed * birth.sigma_speed);
  state.cov.topLeftCorner<2, 2>() = candidate.measurement.cov_F;
  const BallObserver& observer = birth.observer;
  if (observer.place != kNoPlace) {
    const Eigen::Vector2d way_F =
        candidate.measurement.p_F - observer.posture.X_FR.origin().vector();
    const auto slope = place_slope(way_F);
    state.mean.head<2>() -= slope * observer.errors;
    state.cov.topLeftCorner<2, 2>() =
        candidate.cov_own + slope * birth.errors.cov(observer.place) * slope.transpose();
    state.cross.topRows<2>() = -slope * birth.errors.cov_with_all(observer.place);
  }
  return state;
}

/// Somewhere along the ray, up to a robot's height or so.
Considered<6> lifted(const Considered<6>& floor, const BallBirth& birth) {
  constexpr double kHeight = 0.4;       // m above the floor, and how uncertain that is
  constexpr double kSigmaHeight = 0.3;  // m
  const double drop = std::max(0.1, birth.ray.ray_R.origin.z - birth.motion.radius);
  const Eigen::Vector2d way_F =
      birth.candidate.measurement.p_F - birth.observer.posture.X_FR.origin().vector();
  Eigen::Vector3d up;
  up << -way_F / drop, 1.0;
  Considered<6> state = floor;
  state.mean.head<3>() += kHeight * up;
  state.cov.topLeftCorner<3, 3>() += kSigmaHeight * kSigmaHeight * up * up.transpose();
  state.cov(5, 5) = birth.motion.sigma_climb * birth.motion.sigma_climb;
  return state;
}

/// Where its size says that it is in the air; of its climb nothing is known.
Considered<6> in_the_air(const BallBirth& birth) {
  Considered<6> state = placed(birth);
  const auto ball = ball_by_size(birth.ray, birth.motion.radius);
  if (!ball) return state;
  const double c = std::cos(birth.observer.posture.X_FR.theta());
  const double s = std::sin(birth.observer.posture.X_FR.theta());
  Eigen::Matrix2d turn;
  turn << c, -s, s, c;
  state.mean(2) = ball->p_R.z();
  state.cov(2, 2) = ball->cov(2, 2);
  state.cov.block<2, 1>(0, 2) = turn * ball->cov.block<2, 1>(0, 2);
  state.cov.block<1, 2>(2, 0) = state.cov.block<2, 1>(0, 2).transpose();
  state.cov(5, 5) = birth.sigma_speed * birth.sigma_speed;
  return state;
}

}  // namespace

BallBeliefs beliefs_at_birth(const BallBirth& birth, RobotId robot, HostTime exposure) {
  BallBeliefs beliefs;
  if (birth.candidate.is_high) {
    beliefs.push_back({in_the_air(birth), BallMode::kFlying, 1.0, robot, exposure});
    return beliefs;
  }
  Considered<6> state = placed(birth);
  lay_down(state, birth.motion);
  beliefs.push_back({state, BallMode::kRolling, 0.9, robot, exposure});
  beliefs.push_back({lifted(state, birth), BallMode::kFlying, 0.1, robot, exposure});
  return beliefs;
}

}  // namespace teamsight::fusion
