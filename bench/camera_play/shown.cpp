// bench/camera_play/shown.cpp: see shown.hpp.
#include "bench/camera_play/shown.hpp"

#include <algorithm>

namespace teamsight::camera_play {
namespace {

constexpr double kBallNear = 0.3;    // m
constexpr double kPlayerNear = 0.5;  // m

bool is_on(const BallRay& ball, const Eigen::Vector3d& p_R) {
  const Eigen::Vector3d way = p_R - ball.ray_R.origin.vector();
  const Eigen::Vector3d direction = ball.ray_R.direction.normalized();
  const double along = way.dot(direction);
  return along > 0.0 && (way - along * direction).norm() < kBallNear;
}

bool is_at(const ObstacleSighting& obstacle, const Eigen::Vector2d& p_R, double radius) {
  const Eigen::Vector2d foot = obstacle.p_RO.vector();
  const double distance = foot.norm();
  if (distance < 1e-6) return false;
  return (foot * ((distance + radius) / distance) - p_R).norm() < kPlayerNear;
}

}  // namespace

void tell_shown(const play::Moment& moment,
                std::size_t robot,
                double robot_radius,
                play::Frame& frame) {
  const Pose<Robot, Field> X_RF = moment.players[robot].X_FR.inverse();
  frame.seen_balls = 0;
  for (std::size_t i = 0; i < moment.balls.size(); ++i) {
    const Eigen::Vector3d p_R = (X_RF * Point3<Field>::from(moment.balls[i].p_F)).vector();
    const bool is_shown = std::ranges::any_of(
        frame.observation.balls, [&](const BallRay& ball) { return is_on(ball, p_R); });
    if (is_shown) frame.seen_balls |= 1U << i;
  }
  frame.seen_players = 0;
  for (std::size_t i = 0; i < moment.players.size(); ++i) {
    if (i == robot) continue;
    const Eigen::Vector2d p_R = (X_RF * moment.players[i].X_FR.origin()).vector();
    const bool is_shown = std::ranges::any_of(
        frame.observation.obstacles,
        [&](const ObstacleSighting& obstacle) { return is_at(obstacle, p_R, robot_radius); });
    if (is_shown) frame.seen_players |= std::uint64_t{1} << i;
  }
}

}  // namespace teamsight::camera_play
