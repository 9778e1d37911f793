// fusion/world.cpp: from what fusion believes to the world model (fusion/state.hpp).
#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "fusion/ball_choice.hpp"
#include "fusion/state.hpp"

namespace teamsight::fusion {
namespace {

Duration age_of(HostTime then, HostTime now) {
  return std::max(Duration{0}, now - then);
}

WorldBall world_ball(const BallTrack& track, HostTime now, const Parameters& parameters) {
  const BallMoments moments = moments_at(track, now, parameters.ball_motion);
  const TrackBook& book = track.book;
  WorldBall ball;
  ball.track = book.key;
  ball.p_FB = Point3<Field>::from(moments.mean.head<3>());
  ball.v_FB = Velocity3<Field>::from(moments.mean.tail<3>());
  ball.cov_p = moments.cov.topLeftCorner<3, 3>();
  ball.cov_v = moments.cov.bottomRightCorner<3, 3>();
  ball.existence = existence_at(book, now, parameters.ball);
  ball.age = age_of(book.last_hit, now);
  ball.supporters = robots_within(book.supported, now, parameters.support_window);
  const RobotMask others = robots_within(book.rejected, now, parameters.support_window);
  ball.rejected = static_cast<RobotMask>(others & ~ball.supporters);
  return ball;
}

WorldObstacle world_obstacle(const Track& track, HostTime now, const Parameters& parameters) {
  const PlanarMoments moments = moments_at(track, now, parameters.obstacle);
  WorldObstacle obstacle;
  obstacle.track = track.book.key;
  obstacle.p_FO = {moments.mean(0), moments.mean(1)};
  obstacle.v_FO = {moments.mean(2), moments.mean(3)};
  obstacle.cov_p = moments.cov.topLeftCorner<2, 2>();
  obstacle.radius = track.radius;
  obstacle.existence = existence_at(track.book, now, parameters.obstacle);
  obstacle.age = age_of(track.book.last_hit, now);
  obstacle.supporters = robots_within(track.book.supported, now, parameters.support_window);
  return obstacle;
}

/// The posture carried to `now`, corrected by what the others see of it.
void fill_posture(const State& state,
                  const Teammate& known,
                  HostTime now,
                  const Parameters& parameters,
                  WorldTeammate& teammate) {
  const CarriedPosture carried = carried_to(known.posture, now, parameters.teammate);
  teammate.X_FR = carried.X_FR;
  teammate.v_FR = carried.v_FR;
  teammate.cov = carried.cov;
  const ErrorPlace place = state.errors.place_of(known.robot);
  const bool is_known =
      teammate.quarantine == Quarantine::kNone || teammate.quarantine == Quarantine::kBiased;
  if (place == kNoPlace || !is_known) return;
  const Eigen::Vector3d error = state.errors.mean(place).head<3>();
  const Eigen::Vector3d corrected = carried.X_FR.vector() - error;
  teammate.X_FR = {corrected.x(), corrected.y(), corrected.z()};
  const Eigen::Matrix3d cov = state.errors.cov(place).topLeftCorner<3, 3>() + carried.cov_since +
                              state.errors.fresh(place, known.posture.last);
  teammate.cov = 0.5 * (cov + cov.transpose());
}

WorldTeammate world_teammate(const State& state,
                             const Teammate& known,
                             HostTime now,
                             const Parameters& parameters) {
  WorldTeammate teammate;
  teammate.robot = known.robot;
  teammate.status = known.status;
  teammate.half_log_odds = known.half_log_odds;
  teammate.half_log_odds_team = state.trust.half_log_odds(known.robot, parameters.trust);
  teammate.frame = known.frame;
  teammate.age = age_of(known.seen, now);
  teammate.quarantine = quarantine_at(state, known, now, parameters);
  teammate.trust = teammate.quarantine == Quarantine::kNone
                       ? state.trust.trust(known.robot, now, parameters.trust)
                       : 0.0;
  teammate.sees_ball = now - known.ball_seen <= parameters.support_window;
  if (known.posture.time == kNever) {
    // Never located: the status says so; the covariance says anywhere on any field.
    teammate.cov.diagonal() << 100.0, 100.0, 10.0;
    return teammate;
  }
  fill_posture(state, known, now, parameters, teammate);
  return teammate;
}

/// @param sigma  the most, m, of the larger semi-axis
bool is_placed(const Eigen::Matrix2d& cov, double sigma) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(cov, Eigen::EigenvaluesOnly);
  return axes.eigenvalues().maxCoeff() <= sigma * sigma;
}

/// That a place known so well is no further away than this (m); of the round one as wide.
double probability_within(double distance, const Eigen::Matrix2d& cov) {
  return -std::expm1(-distance * distance / cov.trace());
}

bool is_listed(const TrackBook& book, HostTime now, const TrackParameters& parameters) {
  return book.is_confirmed && now - book.last_hit <= parameters.death_age &&
         log_odds_of(book) >
             std::log(parameters.least_existence / (1.0 - parameters.least_existence));
}

template <class List>
void keep_most_probable(List& list, std::size_t count) {
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
    return a.existence > b.existence;
  });
  if (list.size() > count) list.resize(count);
}

bool is_shown(const BallTrack& track,
              const WorldBall& ball,
              HostTime now,
              const Parameters& parameters) {
  return is_listed(track.book, now, parameters.ball) &&
         ball.existence >= parameters.ball.least_existence &&
         is_placed(ball.cov_p.topLeftCorner<2, 2>(), parameters.ball.max_sigma_published);
}

/// In the order of choice. Where one is known too badly to be shown, what comes after it is
/// probably false: that is shown only if more than one robot's word stands for it.
std::vector<WorldBall> best_balls(const State& state, HostTime now, const Parameters& parameters) {
  std::vector<WorldBall> balls;
  bool is_in_shadow = false;
  for (const std::size_t i : order_of_choice(state.balls, state.hinted, now, parameters)) {
    const BallTrack& track = state.balls[i];
    if (is_in_shadow && log_odds_of(track.book) <= parameters.ball.most_vote) continue;
    const WorldBall ball = world_ball(track, now, parameters);
    if (is_shown(track, ball, now, parameters)) {
      balls.push_back(ball);
    } else {
      is_in_shadow = true;
    }
  }
  if (balls.size() > kMaxWorldBalls) balls.resize(kMaxWorldBalls);
  return balls;
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
  world.balls = best_balls(state, now, parameters);
  for (const Track& track : state.obstacles) {
    if (!is_listed(track.book, now, parameters.obstacle)) continue;
    const WorldObstacle obstacle = world_obstacle(track, now, parameters);
    const double is_there =
        obstacle.existence * probability_within(parameters.obstacle_reach, obstacle.cov_p);
    if (is_there >= parameters.obstacle.least_existence) world.obstacles.push_back(obstacle);
  }
  for (const Teammate& teammate : state.teammates) {
    if (now - teammate.seen <= parameters.teammate.forget_age) {
      world.teammates.push_back(world_teammate(state, teammate, now, parameters));
    }
  }
  keep_most_probable(world.obstacles, kMaxWorldObstacles);
  keep_freshest(world.teammates, kMaxWorldTeammates);
  std::sort(world.teammates.begin(), world.teammates.end(), [](const auto& a, const auto& b) {
    return a.robot < b.robot;
  });
  return world;
}

}  // namespace teamsight::fusion
