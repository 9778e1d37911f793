// bus/wire_robot.cpp: the wire forms of what a robot says of itself: state, sensors, odometry.
#include "bus/wire.hpp"
#include "bus/wire_check.hpp"
#include "bus/wire_convert.hpp"

namespace teamsight::bus {
namespace {

constexpr std::uint32_t kMaxReadings = 24;

std::optional<Reject> broken_rule(const teamsight_v1_RobotState& wire) {
  WireCheck check;
  check.robot_sample(wire.robot_id, wire.sample);
  check.stamps(wire.exposure_ns, wire.publish_ns);
  check.posture_report(wire.posture);
  check.within(wire.vx_mps, kLargestSpeed);
  check.within(wire.vy_mps, kLargestSpeed);
  check.within(wire.omega_radps, kLargestTurn);
  check.within(wire.half_log_odds_team, kLargestLogOdds);
  check.flag(wire.playing);
  check.flag(wire.sees_ball);
  check.flag(wire.has_ball);
  check.flag(wire.camera_lost);
  check.flag(wire.muted);
  check.between(wire.frame_rate_hz, 0.0, 1000.0);
  check.between(wire.battery_v, 0.0, 1000.0);
  check.between(wire.cpu_load, 0.0, 1000.0);
  check.within(wire.cpu_temperature_degc, 1000.0);
  check.between(wire.calibration_drift_px, 0.0, 10'000.0);
  check.text(wire.software_version, sizeof wire.software_version);
  return check.broken();
}

std::optional<Reject> broken_rule(const teamsight_v1_VirtualSensors& wire) {
  WireCheck check;
  check.robot_sample(wire.robot_id, wire.sample);
  check.stamp(wire.exposure_ns);
  if (!check.sequence(wire.readings, kMaxReadings)) return check.broken();
  for (std::uint32_t i = 0; i < wire.readings._length; ++i) {
    const teamsight_v1_SensorReading& reading = wire.readings._buffer[i];
    check.text(reading.name, sizeof reading.name);
    check.share(reading.value);
    check.flag(reading.triggered);
  }
  return check.broken();
}

std::optional<Reject> broken_rule(const teamsight_v1_Odometry& wire) {
  constexpr double kFarthestDrive = 1e6;  // m; the drive counts on from its start
  WireCheck check;
  check.robot_sample(wire.robot_id, wire.sample);
  check.stamp(wire.stamp_ns);
  check.within(wire.x_m, kFarthestDrive);
  check.within(wire.y_m, kFarthestDrive);
  check.within(wire.theta_rad, kLargestAngle);
  check.within(wire.vx_mps, kLargestSpeed);
  check.within(wire.vy_mps, kLargestSpeed);
  check.within(wire.omega_radps, kLargestTurn);
  check.between(wire.sigma_v_mps, 0.0, kLargestSpeed);
  check.between(wire.sigma_omega_radps, 0.0, kLargestTurn);
  check.flag(wire.slipping);
  check.within(wire.gyro_radps, kLargestTurn);
  check.between(wire.sigma_gyro_radps, 0.0, kLargestTurn);
  check.within(wire.heading_rad, kLargestAngle);
  check.between(wire.sigma_heading_rad, 0.0, kLargestAngle);
  return check.broken();
}

}  // namespace

template <>
const dds_topic_descriptor_t& topic_descriptor<RobotState>() noexcept {
  return teamsight_v1_RobotState_desc;
}

template <>
const dds_topic_descriptor_t& topic_descriptor<VirtualSensors>() noexcept {
  return teamsight_v1_VirtualSensors_desc;
}

template <>
const dds_topic_descriptor_t& topic_descriptor<Odometry>() noexcept {
  return teamsight_v1_Odometry_desc;
}

template <>
std::optional<Reject> to_wire(const RobotState& message, WireSample<RobotState>& out) {
  Encoding encoding;
  teamsight_v1_RobotState& wire = out.sample;
  wire.robot_id = message.id.robot;
  wire.sample = to_wire(message.id);
  wire.exposure_ns = nanoseconds(message.exposure);
  wire.publish_ns = nanoseconds(message.published);
  wire.posture = to_wire(message.posture);
  wire.vx_mps = single(message.v_R.x);
  wire.vy_mps = single(message.v_R.y);
  wire.omega_radps = single(message.omega);
  wire.half_log_odds_team = single(message.half_log_odds_team);
  wire.command_acknowledged = message.command_acknowledged;
  wire.playing = octet(message.playing);
  wire.sees_ball = octet(message.sees_ball);
  wire.has_ball = octet(message.has_ball);
  wire.camera_lost = octet(message.camera_lost);
  wire.muted = octet(message.muted);
  wire.frame_rate_hz = single(message.frame_rate);
  wire.battery_v = single(message.battery);
  wire.cpu_load = single(message.cpu_load);
  wire.cpu_temperature_degc = single(message.cpu_temperature);
  wire.calibration_drift_px = single(message.calibration_drift);
  encoding.text(message.software_version, wire.software_version, sizeof wire.software_version);
  return encoding.broken() ? encoding.broken() : broken_rule(wire);
}

template <>
Result<RobotState, Reject> from_wire<RobotState>(const teamsight_v1_RobotState& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  RobotState message;
  message.id = from_wire(wire.sample);
  message.exposure = peer_time(wire.exposure_ns);
  message.published = peer_time(wire.publish_ns);
  message.posture = from_wire(wire.posture);
  message.v_R = {static_cast<double>(wire.vx_mps), static_cast<double>(wire.vy_mps)};
  message.omega = static_cast<double>(wire.omega_radps);
  message.half_log_odds_team = static_cast<double>(wire.half_log_odds_team);
  message.command_acknowledged = wire.command_acknowledged;
  message.playing = wire.playing != 0;
  message.sees_ball = wire.sees_ball != 0;
  message.has_ball = wire.has_ball != 0;
  message.camera_lost = wire.camera_lost != 0;
  message.muted = wire.muted != 0;
  message.frame_rate = static_cast<double>(wire.frame_rate_hz);
  message.battery = static_cast<double>(wire.battery_v);
  message.cpu_load = static_cast<double>(wire.cpu_load);
  message.cpu_temperature = static_cast<double>(wire.cpu_temperature_degc);
  message.calibration_drift = static_cast<double>(wire.calibration_drift_px);
  message.software_version = wire.software_version;
  return message;
}

template <>
std::optional<Reject> to_wire(const VirtualSensors& message, WireSample<VirtualSensors>& out) {
  Encoding encoding;
  if (!encoding.fits(message.readings.size(), kMaxReadings)) return encoding.broken();
  teamsight_v1_VirtualSensors& wire = out.sample;
  wire.robot_id = message.id.robot;
  wire.sample = to_wire(message.id);
  wire.exposure_ns = nanoseconds(message.exposure);
  for (std::size_t i = 0; i < message.readings.size(); ++i) {
    const SensorReading& from = message.readings[i];
    teamsight_v1_SensorReading& to = out.storage[i];
    encoding.text(from.name, to.name, sizeof to.name);
    to.value = single(from.value);
    to.triggered = octet(from.triggered);
  }
  lend(out.storage, message.readings.size(), wire.readings);
  return encoding.broken() ? encoding.broken() : broken_rule(wire);
}

template <>
Result<VirtualSensors, Reject> from_wire<VirtualSensors>(const teamsight_v1_VirtualSensors& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  VirtualSensors message;
  message.id = from_wire(wire.sample);
  message.exposure = peer_time(wire.exposure_ns);
  message.readings.reserve(wire.readings._length);
  for (std::uint32_t i = 0; i < wire.readings._length; ++i) {
    const teamsight_v1_SensorReading& from = wire.readings._buffer[i];
    message.readings.push_back({from.name, static_cast<double>(from.value), from.triggered != 0});
  }
  return message;
}

template <>
std::optional<Reject> to_wire(const Odometry& message, WireSample<Odometry>& out) {
  teamsight_v1_Odometry& wire = out.sample;
  wire.robot_id = message.id.robot;
  wire.sample = to_wire(message.id);
  wire.stamp_ns = nanoseconds(message.stamp);
  wire.x_m = single(message.X_DR.x());
  wire.y_m = single(message.X_DR.y());
  wire.theta_rad = single(message.X_DR.theta());
  wire.vx_mps = single(message.v_R.x);
  wire.vy_mps = single(message.v_R.y);
  wire.omega_radps = single(message.omega);
  wire.sigma_v_mps = single(message.sigma_v);
  wire.sigma_omega_radps = single(message.sigma_omega);
  wire.slipping = octet(message.slipping);
  wire.gyro_radps = single(message.gyro);
  wire.sigma_gyro_radps = single(message.sigma_gyro);
  wire.heading_rad = single(message.heading);
  wire.sigma_heading_rad = single(message.sigma_heading);
  return broken_rule(wire);
}

template <>
Result<Odometry, Reject> from_wire<Odometry>(const teamsight_v1_Odometry& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  Odometry message;
  message.id = from_wire(wire.sample);
  message.stamp = peer_time(wire.stamp_ns);
  message.X_DR = Pose<Drive, Robot>(static_cast<double>(wire.x_m),
                                    static_cast<double>(wire.y_m),
                                    static_cast<double>(wire.theta_rad));
  message.v_R = {static_cast<double>(wire.vx_mps), static_cast<double>(wire.vy_mps)};
  message.omega = static_cast<double>(wire.omega_radps);
  message.sigma_v = static_cast<double>(wire.sigma_v_mps);
  message.sigma_omega = static_cast<double>(wire.sigma_omega_radps);
  message.slipping = wire.slipping != 0;
  message.gyro = static_cast<double>(wire.gyro_radps);
  message.sigma_gyro = static_cast<double>(wire.sigma_gyro_radps);
  message.heading = static_cast<double>(wire.heading_rad);
  message.sigma_heading = static_cast<double>(wire.sigma_heading_rad);
  return message;
}

}  // namespace teamsight::bus
