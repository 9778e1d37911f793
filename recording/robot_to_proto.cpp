// recording/robot_to_proto.cpp: the topics of recording/to_proto.hpp that robots and fusions write.
#include "recording/proto_parts.hpp"
#include "recording/to_proto.hpp"

namespace teamsight::recording {

using parts::set;
using parts::to_ms;
using parts::to_ns;

namespace {

void fill(const BallRay& from, v1::BallRay& to) {
  set(from.ray_R.origin, *to.mutable_origin_m());
  to.mutable_direction()->set_x(from.ray_R.direction.x());
  to.mutable_direction()->set_y(from.ray_R.direction.y());
  to.mutable_direction()->set_z(from.ray_R.direction.z());
  parts::add_upper<2>(from.cov_direction, *to.mutable_cov_direction());
  to.set_angular_radius_rad(from.angular_radius);
  to.set_sigma_angular_radius_rad(from.sigma_angular_radius);
  to.set_confidence(from.confidence);
  to.set_colour(static_cast<std::uint32_t>(from.colour));
}

void fill(const ObstacleSighting& from, v1::ObstacleSighting& to) {
  to.set_x_m(from.p_RO.x);
  to.set_y_m(from.p_RO.y);
  parts::add_upper<2>(from.cov_R, *to.mutable_cov());
  to.set_width_m(from.width);
  to.set_confidence(from.confidence);
  to.set_teammate_likelihood(from.teammate_likelihood);
}

void fill(const WorldBall& from, v1::WorldBall& to) {
  to.set_track_id(from.track);
  set(from.p_FB, *to.mutable_p_m());
  set(from.v_FB, *to.mutable_v_mps());
  parts::add_upper<3>(from.cov_p, *to.mutable_cov_p());
  parts::add_upper<3>(from.cov_v, *to.mutable_cov_v());
  to.set_existence(from.existence);
  to.set_age_ms(to_ms(from.age));
  to.set_supporters(from.supporters);
  to.set_rejected(from.rejected);
}

void fill(const WorldTeammate& from, v1::WorldTeammate& to) {
  to.set_robot_id(from.robot);
  to.set_status(static_cast<v1::PostureStatus>(from.status));
  set(from.X_FR, from.cov, *to.mutable_posture());
  to.set_vx_mps(from.v_FR.x);
  to.set_vy_mps(from.v_FR.y);
  to.set_half_log_odds(from.half_log_odds);
  to.set_half_log_odds_team(from.half_log_odds_team);
  to.set_frame(from.frame);
  to.set_age_ms(to_ms(from.age));
  to.set_trust(from.trust);
  to.set_quarantine(static_cast<std::uint32_t>(from.quarantine));
  to.set_sees_ball(from.sees_ball);
}

void fill(const WorldObstacle& from, v1::WorldObstacle& to) {
  to.set_track_id(from.track);
  to.set_x_m(from.p_FO.x);
  to.set_y_m(from.p_FO.y);
  to.set_vx_mps(from.v_FO.x);
  to.set_vy_mps(from.v_FO.y);
  parts::add_upper<2>(from.cov_p, *to.mutable_cov());
  to.set_radius_m(from.radius);
  to.set_existence(from.existence);
  to.set_age_ms(to_ms(from.age));
  to.set_supporters(from.supporters);
}

void fill(const bus::ExplainedTrack& from, v1::ExplainedTrack& to) {
  to.set_track_id(from.track);
  to.set_kind(from.kind == bus::TrackKind::kBall ? "ball" : "obstacle");
  to.set_supporters(from.supporters);
  to.set_rejected(from.rejected);
  to.set_born_s_ago(static_cast<std::uint32_t>(from.born_ago.count()));
  to.set_nis(from.nis);
}

}  // namespace

void to_proto(const bus::RobotState& from, v1::RobotState& to) {
  set(from.id, *to.mutable_sample());
  to.set_exposure_ns(to_ns(from.exposure));
  to.set_publish_ns(to_ns(from.published));
  set(from.posture, *to.mutable_posture());
  to.set_vx_mps(from.v_R.x);
  to.set_vy_mps(from.v_R.y);
  to.set_omega_radps(from.omega);
  to.set_half_log_odds_team(from.half_log_odds_team);
  to.set_command_acknowledged(from.command_acknowledged);
  to.set_playing(from.playing);
  to.set_sees_ball(from.sees_ball);
  to.set_has_ball(from.has_ball);
  to.set_camera_lost(from.camera_lost);
  to.set_muted(from.muted);
  to.set_frame_rate_hz(from.frame_rate);
  to.set_battery_v(from.battery);
  to.set_cpu_load(from.cpu_load);
  to.set_cpu_temperature_degc(from.cpu_temperature);
  to.set_calibration_drift_px(from.calibration_drift);
  to.set_software_version(from.software_version);
}

void to_proto(const bus::Sightings& from, v1::Sightings& to) {
  set(from.id, *to.mutable_sample());
  to.set_exposure_ns(to_ns(from.exposure));
  to.set_publish_ns(to_ns(from.published));
  set(from.posture, *to.mutable_posture());
  to.set_light(static_cast<std::uint32_t>(from.light));
  for (const BallRay& ball : from.balls) fill(ball, *to.add_balls());
  for (const ObstacleSighting& obstacle : from.obstacles) fill(obstacle, *to.add_obstacles());
}

void to_proto(const bus::VirtualSensors& from, v1::VirtualSensors& to) {
  set(from.id, *to.mutable_sample());
  to.set_exposure_ns(to_ns(from.exposure));
  for (const bus::SensorReading& reading : from.readings) {
    v1::SensorReading& entry = *to.add_readings();
    entry.set_name(reading.name);
    entry.set_value(reading.value);
    entry.set_triggered(reading.triggered);
  }
}

void to_proto(const bus::Odometry& from, v1::Odometry& to) {
  set(from.id, *to.mutable_sample());
  to.set_stamp_ns(to_ns(from.stamp));
  to.set_x_m(from.X_DR.x());
  to.set_y_m(from.X_DR.y());
  to.set_theta_rad(from.X_DR.theta());
  to.set_vx_mps(from.v_R.x);
  to.set_vy_mps(from.v_R.y);
  to.set_omega_radps(from.omega);
  to.set_sigma_v_mps(from.sigma_v);
  to.set_sigma_omega_radps(from.sigma_omega);
  to.set_slipping(from.slipping);
  to.set_gyro_radps(from.gyro);
  to.set_sigma_gyro_radps(from.sigma_gyro);
  to.set_heading_rad(from.heading);
  to.set_sigma_heading_rad(from.sigma_heading);
}

void to_proto(const WorldModel& from, v1::WorldModel& to) {
  set(from.id, *to.mutable_sample());
  to.set_strength(from.strength);
  to.set_stamp_ns(to_ns(from.stamp));
  for (const WorldBall& ball : from.balls) fill(ball, *to.add_balls());
  for (const WorldTeammate& teammate : from.teammates) fill(teammate, *to.add_teammates());
  for (const WorldObstacle& obstacle : from.obstacles) fill(obstacle, *to.add_obstacles());
}

void to_proto(const bus::ExplainedHint& from, v1::ExplainedHint& to) {
  to.set_command_id(from.command);
  to.set_track_id(from.track);
  to.set_left_ms(to_ms(from.left));
}

void to_proto(const bus::Explanation& from, v1::Explanation& to) {
  set(from.id, *to.mutable_sample());
  to.set_stamp_ns(to_ns(from.stamp));
  for (const bus::ExplainedTrack& track : from.tracks) fill(track, *to.add_tracks());
  for (const bus::ExplainedRobot& robot : from.robots) set(robot, *to.add_robots());
  if (from.hint.command != 0) to_proto(from.hint, *to.mutable_hint());
}

void to_proto(const bus::LinePoints& from, v1::LinePoints& to) {
  set(from.id, *to.mutable_sample());
  to.set_exposure_ns(to_ns(from.exposure));
  for (const bus::LinePoint& point : from.points) {
    v1::LinePoint& entry = *to.add_points();
    entry.set_x_m(point.p_R.x);
    entry.set_y_m(point.p_R.y);
    entry.set_inlier(point.inlier);
  }
}

void to_proto(const bus::Thumbnail& from, v1::Thumbnail& to) {
  set(from.id, *to.mutable_sample());
  to.set_exposure_ns(to_ns(from.exposure));
  to.set_width_px(from.width_px);
  to.set_height_px(from.height_px);
  to.mutable_jpeg()->assign(from.jpeg.begin(), from.jpeg.end());
}

}  // namespace teamsight::recording
