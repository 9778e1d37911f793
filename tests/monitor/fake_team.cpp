// tests/monitor/fake_team.cpp: see tests/monitor/fake_team.hpp.
#include "tests/monitor/fake_team.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <vector>

namespace teamsight::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Duration kDelay = std::chrono::milliseconds(25);

struct Motion {
  Eigen::Vector2d p;
  Eigen::Vector2d v;
};

/// An ellipse around a home, `period` seconds a turn.
Motion around(const Eigen::Vector2d& home, const Eigen::Vector2d& reach, double period, double t) {
  const double w = 2.0 * kPi / period;
  return {home + Eigen::Vector2d(reach.x() * std::cos(w * t), reach.y() * std::sin(w * t)),
          w * Eigen::Vector2d(-reach.x() * std::sin(w * t), reach.y() * std::cos(w * t))};
}

double seconds_of(HostTime time) {
  return std::fmod(to_seconds(time.time_since_epoch()), 3600.0);
}

Motion ball_at(double t) {
  return around({0.0, 0.0}, {6.5, 4.0}, 14.0, t);
}

Motion robot_at(RobotId robot, double t) {
  static const std::array<Eigen::Vector2d, kFakeRobots> homes{
      Eigen::Vector2d{-10.2, 0.0}, {-5.5, 3.2}, {-5.0, -3.4}, {1.5, 4.0}, {4.0, -2.0}};
  const double reach = robot == 1 ? 0.6 : 1.8;
  const auto index = static_cast<std::size_t>(robot - 1);
  return around(homes[index], {reach, 0.8 * reach}, 9.0 + robot, t + robot);
}

Motion opponent_at(std::size_t index, double t) {
  static const std::array<Eigen::Vector2d, 5> homes{
      Eigen::Vector2d{10.3, 0.2}, {6.0, 2.5}, {5.5, -4.5}, {-1.0, 1.5}, {-3.5, -1.0}};
  return around(homes[index], {1.2, 1.0}, 8.0 + static_cast<double>(index), -t);
}

Pose<Field, Robot> pose_of(RobotId robot, double t) {
  const Motion motion = robot_at(robot, t);
  const Eigen::Vector2d to_ball = ball_at(t).p - motion.p;
  return {motion.p.x(), motion.p.y(), std::atan2(to_ball.y(), to_ball.x())};
}

Eigen::Matrix3d posture_cov(RobotId robot) {
  const double sigma = 0.04 + 0.03 * robot;
  Eigen::Matrix3d cov = Eigen::Vector3d(sigma * sigma, 0.3 * sigma * sigma, 4e-4).asDiagonal();
  cov(0, 1) = cov(1, 0) = 0.25 * sigma * sigma;
  return cov;
}

PostureEstimate posture_of(RobotId robot, double t) {
  PostureEstimate posture;
  posture.status = robot == 4 ? PostureStatus::kAmbiguous : PostureStatus::kOk;
  posture.X_FR = pose_of(robot, t);
  posture.cov = posture_cov(robot);
  posture.half_log_odds = robot == 4 ? 0.4 : 6.0;
  posture.inlier_ratio = robot == 4 ? 0.61 : 0.93;
  posture.line_points = static_cast<std::uint16_t>(90 + 10 * robot);
  return posture;
}

WorldTeammate teammate_at(RobotId robot, double t) {
  WorldTeammate mate;
  const PostureEstimate posture = posture_of(robot, t);
  mate.robot = robot;
  mate.status = posture.status;
  mate.X_FR = posture.X_FR;
  mate.cov = posture.cov;
  mate.v_FR = Velocity<Field>::from(robot_at(robot, t).v);
  mate.half_log_odds = posture.half_log_odds;
  mate.age = std::chrono::milliseconds(30);
  mate.trust = robot == 4 ? 0.2 : 0.97;
  mate.quarantine = robot == 4 ? Quarantine::kBiased : Quarantine::kNone;
  mate.sees_ball = robot != 1;
  return mate;
}

WorldObstacle obstacle_at(std::size_t index, double t) {
  WorldObstacle obstacle;
  const Motion motion = opponent_at(index, t);
  obstacle.track = static_cast<std::uint32_t>(11 + 3 * index);
  obstacle.p_FO = Point<Field>::from(motion.p);
  obstacle.v_FO = Velocity<Field>::from(motion.v);
  obstacle.cov_p = Eigen::Vector2d(0.03, 0.015).asDiagonal();
  obstacle.radius = 0.25;
  obstacle.existence = index == 2 ? 0.55 : 0.98;
  obstacle.age = std::chrono::milliseconds(40);
  obstacle.supporters = 0b00110;
  return obstacle;
}

/// The ball from a mirror 0.7 m above the floor; robot 4 looks past it, as its quarantine says.
BallRay ball_ray_of(RobotId robot, double t) {
  const double aside = robot == 4 ? 1.2 : 0.05;
  const Eigen::Vector2d p_RB = pose_of(robot, t).rotation().transpose() *
                               (ball_at(t).p + Eigen::Vector2d(aside, 0.0) - robot_at(robot, t).p);
  const Eigen::Vector3d direction = Eigen::Vector3d(p_RB.x(), p_RB.y(), 0.11 - 0.7).normalized();
  BallRay ball;
  ball.ray_R.origin = {0.0, 0.0, 0.7};
  ball.ray_R.direction = direction;
  ball.cov_direction = 1e-4 * Eigen::Matrix2d::Identity();
  ball.confidence = 0.9;
  return ball;
}

/// The opponents within its sight.
std::vector<ObstacleSighting> obstacles_of(RobotId robot, double t) {
  std::vector<ObstacleSighting> sightings;
  for (std::size_t i = 0; i < 5; ++i) {
    const Eigen::Vector2d p_RO =
        pose_of(robot, t).rotation().transpose() * (opponent_at(i, t).p - robot_at(robot, t).p);
    if (p_RO.norm() > 6.0) continue;
    ObstacleSighting sighting;
    sighting.p_RO = {p_RO.x(), p_RO.y()};
    sighting.cov_R = 0.04 * Eigen::Matrix2d::Identity();
    sighting.width = 0.5;
    sighting.confidence = 0.9;
    sightings.push_back(sighting);
  }
  return sightings;
}

}  // namespace

bus::RobotState fake_state(const ObservationId& id, HostTime exposure) {
  const double t = seconds_of(exposure);
  bus::RobotState state;
  state.id = id;
  state.exposure = stamp_of(exposure);
  state.published = stamp_of(exposure + kDelay);
  state.posture = posture_of(id.robot, t);
  const Eigen::Vector2d v_R = state.posture.X_FR.rotation().transpose() * robot_at(id.robot, t).v;
  state.v_R = Velocity<Robot>::from(v_R);
  state.sees_ball = id.robot != 1;
  state.frame_rate = 25.0;
  state.battery = 24.6;
  state.cpu_load = 0.18 + 0.02 * id.robot;
  state.cpu_temperature = 58.0 + id.robot;
  state.software_version = "0.1.0";
  return state;
}

bus::Sightings fake_sightings(const ObservationId& id, HostTime exposure) {
  const double t = seconds_of(exposure);
  bus::Sightings sightings;
  sightings.id = id;
  sightings.exposure = stamp_of(exposure);
  sightings.published = stamp_of(exposure + kDelay);
  sightings.posture = posture_of(id.robot, t);
  sightings.light = bus::Light::kGood;
  if (id.robot != 1) sightings.balls.push_back(ball_ray_of(id.robot, t));
  sightings.obstacles = obstacles_of(id.robot, t);
  return sightings;
}

bus::VirtualSensors fake_sensors(const ObservationId& id, HostTime exposure) {
  const double wave = 0.5 + 0.5 * std::sin(seconds_of(exposure));
  return {
      id,
      stamp_of(exposure),
      {{"ball in front", wave, wave > 0.6}, {"ball held", 0.1 * wave, false}, {"goal", 0.7, true}}};
}

WorldModel fake_world(const ObservationId& id, HostTime stamp) {
  const double t = seconds_of(stamp);
  WorldModel world;
  world.id = id;
  world.strength = 30;
  world.stamp = stamp_of(stamp);
  const Motion ball = ball_at(t);
  WorldBall known;
  known.track = 7;
  known.p_FB = {ball.p.x(), ball.p.y(), 0.11};
  known.v_FB = {ball.v.x(), ball.v.y(), 0.0};
  known.cov_p = Eigen::Vector3d(0.02, 0.045, 1e-4).asDiagonal();
  known.cov_p(0, 1) = known.cov_p(1, 0) = 0.012;
  known.cov_v = 0.1 * Eigen::Matrix3d::Identity();
  known.existence = 0.97;
  known.age = std::chrono::milliseconds(35);
  known.supporters = 0b10110;
  known.rejected = 0b01000;
  world.balls.push_back(known);
  for (RobotId robot = 1; robot <= kFakeRobots; ++robot) {
    world.teammates.push_back(teammate_at(robot, t));
  }
  for (std::size_t i = 0; i < 5; ++i) world.obstacles.push_back(obstacle_at(i, t));
  return world;
}

bus::Explanation fake_explanation(const ObservationId& id, HostTime stamp) {
  bus::Explanation explanation;
  explanation.id = id;
  explanation.stamp = stamp_of(stamp);
  for (RobotId robot = 1; robot <= kFakeRobots; ++robot) {
    bus::ExplainedRobot entry;
    entry.robot = robot;
    entry.trust = robot == 4 ? 0.2 : 0.97;
    entry.quarantine = robot == 4 ? Quarantine::kBiased : Quarantine::kNone;
    entry.accepted = 25 * id.sequence;
    entry.rejected_gate = robot == 4 ? 12 * id.sequence : robot;
    entry.rejected_late = robot == 2 ? 3U : 0U;
    explanation.robots.push_back(entry);
  }
  return explanation;
}

bus::Truth fake_truth(const ObservationId& id, HostTime stamp) {
  const double t = seconds_of(stamp);
  bus::Truth truth;
  truth.id = id;
  truth.stamp = stamp_of(stamp);
  const Motion ball = ball_at(t);
  truth.p_FB = {ball.p.x() + 0.1, ball.p.y() - 0.1, 0.11};
  truth.v_FB = {ball.v.x(), ball.v.y(), 0.0};
  for (RobotId robot = 1; robot <= kFakeRobots; ++robot) {
    truth.robots.push_back({robot, pose_of(robot, t), Velocity<Field>::from(robot_at(robot, t).v)});
  }
  return truth;
}

}  // namespace teamsight::test
