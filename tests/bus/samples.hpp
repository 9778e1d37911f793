// tests/bus/samples.hpp: one full message per topic, every list at its bound, for round trips.
//
// All numbers survive the wire exactly: floats are short binary fractions, percents whole.
#pragma once

#include <string>

#include "bus/messages.hpp"

namespace teamsight::bus::testing {

inline constexpr RobotId kRobot = 3;

inline ObservationId some_id(std::uint32_t sequence = 7) {
  return {kRobot, 0xCAFE, sequence};
}

inline PeerTime at_ms(std::int64_t count) {
  return PeerTime{std::chrono::milliseconds(count)};
}

inline Eigen::Matrix3d some_cov3() {
  Eigen::Matrix3d cov;
  cov << 0.5, 0.125, 0.0625, 0.125, 0.25, 0.03125, 0.0625, 0.03125, 0.125;
  return cov;
}

inline Eigen::Matrix2d some_cov2() {
  return some_cov3().topLeftCorner<2, 2>();
}

inline PostureEstimate some_posture() {
  return {PostureStatus::kOk, Pose<Field, Robot>(1.5, -2.25, 0.75), some_cov3(), 3.5, 0.75, 180};
}

template <class Message>
Message full();

template <>
inline RobotState full<RobotState>() {
  RobotState m;
  m.id = some_id();
  m.exposure = at_ms(1000);
  m.published = at_ms(1020);
  m.posture = some_posture();
  m.v_R = {1.25, -0.5};
  m.omega = -2.0;
  m.half_log_odds_team = 1.75;
  m.command_acknowledged = 42;
  m.playing = false;
  m.sees_ball = m.has_ball = m.camera_lost = m.muted = true;
  m.frame_rate = 25.0;
  m.battery = 23.5;
  m.cpu_load = 0.625;
  m.cpu_temperature = 61.5;
  m.calibration_drift = 0.25;
  m.software_version = std::string(15, 'v');
  return m;
}

template <>
inline Sightings full<Sightings>() {
  Sightings m;
  m.id = some_id();
  m.exposure = at_ms(1000);
  m.published = at_ms(1020);
  m.posture = some_posture();
  m.light = Light::kGlare;
  BallRay ball;
  ball.ray_R = {{0.0, 0.125, 0.5}, {0.0, 0.0, -1.0}};
  ball.angular_radius = 0.0625;
  ball.cov_direction = some_cov2();
  ball.sigma_angular_radius = 0.015625;
  ball.confidence = 0.875;
  ball.colour = BallColour::kPatterned;
  m.balls.assign(kMaxBallRays, ball);
  m.obstacles.assign(kMaxObstacleSightings,
                     ObstacleSighting{{2.5, -1.5}, some_cov2(), 0.5, 0.9, 0.25});
  return m;
}

template <>
inline VirtualSensors full<VirtualSensors>() {
  VirtualSensors m{some_id(), at_ms(1000), {}};
  m.readings.assign(24, SensorReading{std::string(23, 's'), 0.375, true});
  return m;
}

template <>
inline Odometry full<Odometry>() {
  return {some_id(),
          at_ms(1000),
          Pose<Drive, Robot>(120.5, -3.25, 2.5),
          {1.5, 0.25},
          -0.5,
          0.125,
          0.0625,
          true,
          -0.5625,
          0.015625,
          2.25,
          0.25};
}

template <>
inline WorldModel full<WorldModel>() {
  WorldModel m;
  m.id = some_id();
  m.strength = 900;
  m.stamp = at_ms(1000);
  WorldBall ball{7, {1.5, 2.5, 0.125}, {-3.0, 0.5, 0.25}, some_cov3(), some_cov3(), 0.97, {}, 5, 2};
  ball.age = std::chrono::milliseconds(120);
  m.balls.assign(kMaxWorldBalls, ball);
  WorldTeammate mate;
  mate.robot = kRobot;
  mate.status = PostureStatus::kAmbiguous;
  mate.X_FR = {-4.5, 3.0, -1.25};
  mate.v_FR = {0.5, -0.25};
  mate.cov = some_cov3();
  mate.half_log_odds = -2.5;
  mate.half_log_odds_team = 7.25;
  mate.frame = 4711;
  mate.age = std::chrono::milliseconds(40);
  mate.trust = 0.5;
  mate.quarantine = Quarantine::kKidnapped;
  mate.sees_ball = true;
  m.teammates.assign(kMaxWorldTeammates, mate);
  WorldObstacle obstacle{9, {0.5, 0.25}, {1.0, -1.0}, some_cov2(), 250 * 0.001, 0.75, {}, 0xFFFF};
  obstacle.age = std::chrono::milliseconds(65'535);
  m.obstacles.assign(kMaxWorldObstacles, obstacle);
  return m;
}

template <>
inline Explanation full<Explanation>() {
  Explanation m{some_id(), at_ms(1000), {}, {}, {77, 8, std::chrono::milliseconds(4500)}};
  m.tracks.assign(14, {8, TrackKind::kObstacle, 3, 4, std::chrono::seconds(99), 1.125});
  m.robots.assign(16,
                  {kRobot,
                   0.75,
                   Quarantine::kBiased,
                   1,
                   2,
                   3,
                   4,
                   5,
                   std::chrono::hours(-400) + Duration{1},
                   std::chrono::microseconds(500)});
  return m;
}

template <>
inline ClockProbe full<ClockProbe>() {
  return {some_id(), at_ms(1000)};
}

template <>
inline ClockEcho full<ClockEcho>() {
  ClockEcho m{some_id(), at_ms(1000), {}};
  m.replies.assign(16, {{5, 99, 12}, at_ms(990)});
  return m;
}

template <>
inline GameState full<GameState>() {
  return {some_id(),
          at_ms(1000),
          GamePhase::kShootout,
          SetPiece::kPark,
          true,
          true,
          3,
          4,
          true,
          std::chrono::milliseconds(70'000)};
}

template <>
inline Command full<Command>() {
  return {some_id(),
          5,
          77,
          CommandKind::kThumbnail,
          Pose<Field, Robot>(1.0, -1.0, 0.5),
          some_cov3(),
          std::chrono::seconds(10)};
}

template <>
inline Diagnostics full<Diagnostics>() {
  Diagnostics m;
  m.process = std::string(39, 'p');
  m.id = some_id();
  m.stamp = at_ms(1000);
  m.healthy = false;
  m.message = std::string(93, 'm') + "\xC3\xA4";  // ends in a letter of two bytes
  m.frame_age_ms = -1.0;
  m.step_ms_p50 = 4.5;
  m.step_ms_p95 = 9.25;
  m.cpu_load = 0.5;
  m.resident_kb = 120'000;
  m.wire_bps = 250'000.0;
  m.thrift = 4;
  m.secured = true;
  m.counters.assign(18, Counter{std::string(39, 'c'), std::uint64_t{1} << 60U});
  return m;
}

template <>
inline LinePoints full<LinePoints>() {
  LinePoints m{some_id(), at_ms(1000), {}};
  m.points.assign(200, LinePoint{{1500 * 0.001, -32'000 * 0.001}, true});
  return m;
}

template <>
inline Thumbnail full<Thumbnail>() {
  Thumbnail m{some_id(), at_ms(1000), 320, 240, {}};
  m.jpeg.assign(32'768, 0xD8);
  return m;
}

template <>
inline Truth full<Truth>() {
  Truth m{some_id(), at_ms(1000), {1.0, 2.0, 0.125}, {0.5, 0.25, 4.0}, {}};
  m.robots.assign(20, TrueRobot{17, Pose<Field, Robot>(3.0, -3.0, 1.5), {0.5, 0.75}});
  return m;
}

}  // namespace teamsight::bus::testing
