// recording/robot_from_proto.cpp: the topics of recording/from_proto.hpp that robots and fusions
// write.
#include "recording/from_proto.hpp"
#include "recording/proto_values.hpp"

namespace teamsight::recording {

using parts::Decoding;
using parts::set;
using parts::stamp;

namespace {

BallRay ray(const v1::BallRay& from, Decoding& decoding) {
  BallRay to;
  set(from.origin_m(), to.ray_R.origin);
  to.ray_R.direction = {from.direction().x(), from.direction().y(), from.direction().z()};
  to.cov_direction = decoding.cov<2>(from.cov_direction());
  to.angular_radius = from.angular_radius_rad();
  to.sigma_angular_radius = from.sigma_angular_radius_rad();
  to.confidence = from.confidence();
  to.colour = decoding.code(from.colour(), BallColour::kPatterned);
  return to;
}

ObstacleSighting obstacle(const v1::ObstacleSighting& from, Decoding& decoding) {
  return {{from.x_m(), from.y_m()},
          decoding.cov<2>(from.cov()),
          from.width_m(),
          from.confidence(),
          from.teammate_likelihood()};
}

WorldBall ball(const v1::WorldBall& from, Decoding& decoding) {
  WorldBall to;
  to.track = from.track_id();
  set(from.p_m(), to.p_FB);
  set(from.v_mps(), to.v_FB);
  to.cov_p = decoding.cov<3>(from.cov_p());
  to.cov_v = decoding.cov<3>(from.cov_v());
  to.existence = from.existence();
  to.age = decoding.from_ms(from.age_ms());
  to.supporters = decoding.narrow<RobotMask>(from.supporters());
  to.rejected = decoding.narrow<RobotMask>(from.rejected());
  return to;
}

WorldTeammate teammate(const v1::WorldTeammate& from, Decoding& decoding) {
  WorldTeammate to;
  to.robot = decoding.narrow<RobotId>(from.robot_id());
  to.status = decoding.code(from.status(), PostureStatus::kOk);
  to.X_FR = decoding.pose(from.posture());
  to.v_FR = {from.vx_mps(), from.vy_mps()};
  to.cov = decoding.cov<3>(from.posture().cov());
  to.half_log_odds = from.half_log_odds();
  to.half_log_odds_team = from.half_log_odds_team();
  to.frame = from.frame();
  to.age = decoding.from_ms(from.age_ms());
  to.trust = from.trust();
  to.quarantine = decoding.code(from.quarantine(), Quarantine::kDuplicateId);
  to.sees_ball = from.sees_ball();
  return to;
}

WorldObstacle obstacle(const v1::WorldObstacle& from, Decoding& decoding) {
  WorldObstacle to;
  to.track = from.track_id();
  to.p_FO = {from.x_m(), from.y_m()};
  to.v_FO = {from.vx_mps(), from.vy_mps()};
  to.cov_p = decoding.cov<2>(from.cov());
  to.radius = from.radius_m();
  to.existence = from.existence();
  to.age = decoding.from_ms(from.age_ms());
  to.supporters = decoding.narrow<RobotMask>(from.supporters());
  return to;
}

bus::RobotState value(const v1::RobotState& from, Decoding& decoding) {
  bus::RobotState to;
  to.id = decoding.id(from.sample());
  to.exposure = stamp(from.exposure_ns());
  to.published = stamp(from.publish_ns());
  to.posture = decoding.posture(from.posture());
  to.v_R = {from.vx_mps(), from.vy_mps()};
  to.omega = from.omega_radps();
  to.half_log_odds_team = from.half_log_odds_team();
  to.command_acknowledged = from.command_acknowledged();
  to.playing = from.playing();
  to.sees_ball = from.sees_ball();
  to.has_ball = from.has_ball();
  to.camera_lost = from.camera_lost();
  to.muted = from.muted();
  to.frame_rate = from.frame_rate_hz();
  to.battery = from.battery_v();
  to.cpu_load = from.cpu_load();
  to.cpu_temperature = from.cpu_temperature_degc();
  to.calibration_drift = from.calibration_drift_px();
  to.software_version = from.software_version();
  return to;
}

bus::Sightings value(const v1::Sightings& from, Decoding& decoding) {
  bus::Sightings to;
  to.id = decoding.id(from.sample());
  to.exposure = stamp(from.exposure_ns());
  to.published = stamp(from.publish_ns());
  to.posture = decoding.posture(from.posture());
  to.light = decoding.code(from.light(), bus::Light::kCovered);
  for (const auto& entry : from.balls()) to.balls.push_back(ray(entry, decoding));
  for (const auto& entry : from.obstacles()) to.obstacles.push_back(obstacle(entry, decoding));
  return to;
}

bus::VirtualSensors value(const v1::VirtualSensors& from, Decoding& decoding) {
  bus::VirtualSensors to{decoding.id(from.sample()), stamp(from.exposure_ns()), {}};
  for (const auto& entry : from.readings()) {
    to.readings.push_back({entry.name(), entry.value(), entry.triggered()});
  }
  return to;
}

bus::Odometry value(const v1::Odometry& from, Decoding& decoding) {
  const Pose<Field, Robot> pose = decoding.pose(from);
  return {decoding.id(from.sample()),
          stamp(from.stamp_ns()),
          {pose.x(), pose.y(), pose.theta()},
          {from.vx_mps(), from.vy_mps()},
          from.omega_radps(),
          from.sigma_v_mps(),
          from.sigma_omega_radps(),
          from.slipping(),
          from.gyro_radps(),
          from.sigma_gyro_radps(),
          from.heading_rad(),
          from.sigma_heading_rad()};
}

WorldModel value(const v1::WorldModel& from, Decoding& decoding) {
  WorldModel to;
  to.id = decoding.id(from.sample());
  to.strength = decoding.narrow<std::uint16_t>(from.strength());
  to.stamp = stamp(from.stamp_ns());
  for (const auto& entry : from.balls()) to.balls.push_back(ball(entry, decoding));
  for (const auto& entry : from.teammates()) to.teammates.push_back(teammate(entry, decoding));
  for (const auto& entry : from.obstacles()) to.obstacles.push_back(obstacle(entry, decoding));
  return to;
}

bus::LinePoints value(const v1::LinePoints& from, Decoding& decoding) {
  bus::LinePoints to{decoding.id(from.sample()), stamp(from.exposure_ns()), {}};
  for (const auto& entry : from.points()) {
    to.points.push_back({{entry.x_m(), entry.y_m()}, entry.inlier()});
  }
  return to;
}

bus::Thumbnail value(const v1::Thumbnail& from, Decoding& decoding) {
  return {decoding.id(from.sample()),
          stamp(from.exposure_ns()),
          decoding.narrow<std::uint16_t>(from.width_px()),
          decoding.narrow<std::uint16_t>(from.height_px()),
          {from.jpeg().begin(), from.jpeg().end()}};
}

}  // namespace

template <>
std::optional<bus::RobotState> from_payload(std::string_view payload) {
  return parts::decode<bus::RobotState>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<bus::Sightings> from_payload(std::string_view payload) {
  return parts::decode<bus::Sightings>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<bus::VirtualSensors> from_payload(std::string_view payload) {
  return parts::decode<bus::VirtualSensors>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<bus::Odometry> from_payload(std::string_view payload) {
  return parts::decode<bus::Odometry>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<WorldModel> from_payload(std::string_view payload) {
  return parts::decode<WorldModel>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<bus::LinePoints> from_payload(std::string_view payload) {
  return parts::decode<bus::LinePoints>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<bus::Thumbnail> from_payload(std::string_view payload) {
  return parts::decode<bus::Thumbnail>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

}  // namespace teamsight::recording
