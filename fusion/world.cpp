// fusion/world.cpp: from what fusion believes to the world model (fusion/state.hpp).
#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "fusion/state.hpp"

namespace teamsight::fusion {
namespace {

// The ball is taken to lie on the floor; how far its height and its climb may differ from that.
constexpr double kSigmaHeight = 0.03;  // m
constexpr double kSigmaClimb = 0.3;    // m/s

Duration age_of(HostTime then, HostTime now) {
  return std::max(Duration{0}, now - then);
}

WorldBall world_ball(const Track& track, HostTime now, const Parameters& parameters) {
  const PlanarMoments moments = moments_at(track, now, parameters.ball);
  WorldBall ball;
  ball.track = track.key;
  ball.p_FB = {moments.mean(0), moments.mean(1), parameters.ball_radius};
  ball.v_FB = {moments.mean(2), moments.mean(3), 0.0};
  ball.cov_p.setZero();
  ball.cov_p.topLeftCorner<2, 2>() = moments.cov.topLeftCorner<2, 2>();
  ball.cov_p(2, 2) = kSigmaHeight * kSigmaHeight;
  ball.cov_v.setZero();
  ball.cov_v.topLeftCorner<2, 2>() = moments.cov.bottomRightCorner<2, 2>();
  ball.cov_v(2, 2) = kSigmaClimb * kSigmaClimb;
  ball.existence = existence_at(track, now, parameters.ball);
  ball.age = age_of(track.last_hit, now);
  ball.supporters = robots_within(track.supported, now, parameters.support_window);
  const RobotMask others = robots_within(track.rejected, now, parameters.support_window);
  ball.rejected = static_cast<RobotMask>(others & ~ball.supporters);
  return ball;
}

WorldObstacle world_obstacle(const Track& track, HostTime now, const Parameters& parameters) {
  const PlanarMoments moments = moments_at(track, now, parameters.obstacle);
  WorldObstacle obstacle;
  obstacle.track = track.key;
  obstacle.p_FO = {moments.mean(0), moments.mean(1)};
  obstacle.v_FO = {moments.mean(2), moments.mean(3)};
  obstacle.cov_p = moments.cov.topLeftCorner<2, 2>();
  obstacle.radius = track.radius;
  obstacle.existence = existence_at(track, now, parameters.obstacle);
  obstacle.age = age_of(track.last_hit, now);
  obstacle.supporters = robots_within(track.supported, now, parameters.support_window);
  return obstacle;
}

WorldTeammate world_teammate(const Teammate& known, HostTime now, const Parameters& parameters) {
  WorldTeammate teammate;
  teammate.robot = known.robot;
  teammate.status = known.status;
  teammate.half_log_odds = known.half_log_odds;
  teammate.frame = known.frame;
  teammate.age = age_of(known.seen, now);
  teammate.quarantine = quarantine_of(known, now, parameters.teammate);
  teammate.trust = teammate.quarantine == Quarantine::kNone ? 1.0 : 0.0;
  teammate.sees_ball = now - known.ball_seen <= parameters.support_window;
  if (known.posture.time == kNever) {
    // Never located: the status says so; the covariance says anywhere on any field.
    teammate.cov.diagonal() << 100.0, 100.0, 10.0;
    return teammate;
  }
  const CarriedPosture carried = carried_to(known.posture, now, parameters.teammate);
  teammate.X_FR = carried.X_FR;
  teammate.v_FR = carried.v_FR;
  teammate.cov = carried.cov;
  return teammate;
}

bool is_placed(const Eigen::Matrix2d& cov, const TrackParameters& parameters) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(cov, Eigen::EigenvaluesOnly);
  return axes.eigenvalues().maxCoeff() <= std::pow(parameters.max_sigma_published, 2);
}

bool is_listed(const Track& track, HostTime now, const TrackParameters& parameters) {
  return track.is_confirmed && now - track.last_hit <= parameters.death_age;
}

template <class List>
void keep_most_probable(List& list, std::size_t count) {
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
    return a.existence > b.existence;
  });
  if (list.size() > count) list.resize(count);
}

void keep_freshest(std::vector<WorldTeammate>& list, std::size_t count) {
  std::stable_sort(
      list.begin(), list.end(), [](const auto& a, const auto& b) { return a.age < b.age; });
  if (list.size() > count) list.resize(count);
}

}  // namespace

WorldModel world_of(const State& state, HostTime now, const Parameters& parameters) {
  WorldModel world;
  world.stamp = stamp_of(now);
  for (const Track& track : state.balls) {
    if (!is_listed(track, now, parameters.ball)) continue;
    const WorldBall ball = world_ball(track, now, parameters);
    if (is_placed(ball.cov_p.topLeftCorner<2, 2>(), parameters.ball)) world.balls.push_back(ball);
  }
  for (const Track& track : state.obstacles) {
    if (!is_listed(track, now, parameters.obstacle)) continue;
    const WorldObstacle obstacle = world_obstacle(track, now, parameters);
    if (is_placed(obstacle.cov_p, parameters.obstacle)) world.obstacles.push_back(obstacle);
  }
  for (const Teammate& teammate : state.teammates) {
    if (now - teammate.seen <= parameters.teammate.forget_age) {
      world.teammates.push_back(world_teammate(teammate, now, parameters));
    }
  }
  keep_most_probable(world.balls, kMaxWorldBalls);
  keep_most_probable(world.obstacles, kMaxWorldObstacles);
  keep_freshest(world.teammates, kMaxWorldTeammates);
  std::sort(world.teammates.begin(), world.teammates.end(), [](const auto& a, const auto& b) {
    return a.robot < b.robot;
  });
  return world;
}

}  // namespace teamsight::fusion
