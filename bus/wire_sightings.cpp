// bus/wire_sightings.cpp: the wire forms of what a camera saw: sightings, line points, thumbnails.
#include "bus/wire.hpp"
#include "bus/wire_check.hpp"
#include "bus/wire_convert.hpp"

namespace teamsight::bus {
namespace {

constexpr std::uint32_t kMaxLinePoints = 200;
constexpr std::uint32_t kMaxJpeg = 32'768;
constexpr double kMillimetre = 0.001;

void check_ball(WireCheck& check, const teamsight_v1_BallRay& ball) {
  constexpr double kQuarterTurn = 1.5708;
  double square = 0.0;
  for (int i = 0; i < 3; ++i) {
    check.within(ball.origin_m[i], kLargestDistance);
    check.within(ball.direction[i], 1.001);
    square += static_cast<double>(ball.direction[i]) * static_cast<double>(ball.direction[i]);
  }
  check.between(square, 0.999, 1.001);
  check.covariance(ball.cov_direction, 2);
  check.between(ball.angular_radius_rad, 0.0, kQuarterTurn);
  check.between(ball.sigma_angular_radius_rad, 0.0, kQuarterTurn);
  check.share(ball.confidence);
  check.code(ball.colour, static_cast<std::uint8_t>(BallColour::kPatterned));
}

void check_obstacle(WireCheck& check, const teamsight_v1_ObstacleSighting& obstacle) {
  check.within(obstacle.x_m, kLargestDistance);
  check.within(obstacle.y_m, kLargestDistance);
  check.covariance(obstacle.cov, 2);
  check.between(obstacle.width_m, 0.0, kLargestDistance);
  check.percent(obstacle.confidence_percent);
  check.percent(obstacle.teammate_percent);
}

std::optional<Reject> broken_rule(const teamsight_v1_Sightings& wire) {
  WireCheck check;
  check.robot_sample(wire.robot_id, wire.sample);
  check.stamps(wire.exposure_ns, wire.publish_ns);
  check.posture_report(wire.posture);
  check.code(wire.light, static_cast<std::uint8_t>(Light::kCovered));
  if (!check.sequence(wire.balls, kMaxBallRays)) return check.broken();
  if (!check.sequence(wire.obstacles, kMaxObstacleSightings)) return check.broken();
  for (std::uint32_t i = 0; i < wire.balls._length; ++i) check_ball(check, wire.balls._buffer[i]);
  for (std::uint32_t i = 0; i < wire.obstacles._length; ++i) {
    check_obstacle(check, wire.obstacles._buffer[i]);
  }
  return check.broken();
}

std::optional<Reject> broken_rule(const teamsight_v1_LinePoints& wire) {
  WireCheck check;
  check.robot_sample(wire.robot_id, wire.sample);
  check.stamp(wire.exposure_ns);
  if (!check.sequence(wire.points, kMaxLinePoints)) return check.broken();
  for (std::uint32_t i = 0; i < wire.points._length; ++i) {
    check.flag(wire.points._buffer[i].inlier);
  }
  return check.broken();
}

std::optional<Reject> broken_rule(const teamsight_v1_Thumbnail& wire) {
  WireCheck check;
  check.robot_sample(wire.robot_id, wire.sample);
  check.stamp(wire.exposure_ns);
  check.require(check.sequence(wire.jpeg, kMaxJpeg), Reject::kUnbounded);
  return check.broken();
}

void write_ball(const BallRay& from, teamsight_v1_BallRay& to) {
  to.origin_m[0] = single(from.ray_R.origin.x);
  to.origin_m[1] = single(from.ray_R.origin.y);
  to.origin_m[2] = single(from.ray_R.origin.z);
  for (int i = 0; i < 3; ++i) to.direction[i] = single(from.ray_R.direction[i]);
  write_triangle<2>(from.cov_direction, to.cov_direction);
  to.angular_radius_rad = single(from.angular_radius);
  to.sigma_angular_radius_rad = single(from.sigma_angular_radius);
  to.confidence = single(from.confidence);
  to.colour = static_cast<std::uint8_t>(from.colour);
}

BallRay read_ball(const teamsight_v1_BallRay& from) {
  BallRay to;
  to.ray_R.origin = {static_cast<double>(from.origin_m[0]),
                     static_cast<double>(from.origin_m[1]),
                     static_cast<double>(from.origin_m[2])};
  // Unit length again: a float keeps it to 1e-7 only.
  to.ray_R.direction = Eigen::Vector3d(static_cast<double>(from.direction[0]),
                                       static_cast<double>(from.direction[1]),
                                       static_cast<double>(from.direction[2]))
                           .normalized();
  to.cov_direction = symmetric<2>(from.cov_direction);
  to.angular_radius = static_cast<double>(from.angular_radius_rad);
  to.sigma_angular_radius = static_cast<double>(from.sigma_angular_radius_rad);
  to.confidence = static_cast<double>(from.confidence);
  to.colour = static_cast<BallColour>(from.colour);
  return to;
}

void write_obstacle(const ObstacleSighting& from,
                    teamsight_v1_ObstacleSighting& to,
                    Encoding& encoding) {
  to.x_m = single(from.p_RO.x);
  to.y_m = single(from.p_RO.y);
  write_triangle<2>(from.cov_R, to.cov);
  to.width_m = single(from.width);
  to.confidence_percent = encoding.percent(from.confidence);
  to.teammate_percent = encoding.percent(from.teammate_likelihood);
}

ObstacleSighting read_obstacle(const teamsight_v1_ObstacleSighting& from) {
  ObstacleSighting to;
  to.p_RO = {static_cast<double>(from.x_m), static_cast<double>(from.y_m)};
  to.cov_R = symmetric<2>(from.cov);
  to.width = static_cast<double>(from.width_m);
  to.confidence = share(from.confidence_percent);
  to.teammate_likelihood = share(from.teammate_percent);
  return to;
}

}  // namespace

template <>
const dds_topic_descriptor_t& topic_descriptor<Sightings>() noexcept {
  return teamsight_v1_Sightings_desc;
}

template <>
const dds_topic_descriptor_t& topic_descriptor<LinePoints>() noexcept {
  return teamsight_v1_LinePoints_desc;
}

template <>
const dds_topic_descriptor_t& topic_descriptor<Thumbnail>() noexcept {
  return teamsight_v1_Thumbnail_desc;
}

template <>
std::optional<Reject> to_wire(const Sightings& message, WireSample<Sightings>& out) {
  Encoding encoding;
  if (!encoding.fits(message.balls.size(), kMaxBallRays)) return encoding.broken();
  if (!encoding.fits(message.obstacles.size(), kMaxObstacleSightings)) return encoding.broken();
  teamsight_v1_Sightings& wire = out.sample;
  wire.robot_id = message.id.robot;
  wire.sample = to_wire(message.id);
  wire.exposure_ns = nanoseconds(message.exposure);
  wire.publish_ns = nanoseconds(message.published);
  wire.posture = to_wire(message.posture);
  wire.light = static_cast<std::uint8_t>(message.light);
  for (std::size_t i = 0; i < message.balls.size(); ++i) {
    write_ball(message.balls[i], out.storage.balls[i]);
  }
  for (std::size_t i = 0; i < message.obstacles.size(); ++i) {
    write_obstacle(message.obstacles[i], out.storage.obstacles[i], encoding);
  }
  lend(out.storage.balls, message.balls.size(), wire.balls);
  lend(out.storage.obstacles, message.obstacles.size(), wire.obstacles);
  return encoding.broken() ? encoding.broken() : broken_rule(wire);
}

template <>
Result<Sightings, Reject> from_wire<Sightings>(const teamsight_v1_Sightings& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  Sightings message;
  message.id = from_wire(wire.sample);
  message.exposure = peer_time(wire.exposure_ns);
  message.published = peer_time(wire.publish_ns);
  message.posture = from_wire(wire.posture);
  message.light = static_cast<Light>(wire.light);
  message.balls.reserve(wire.balls._length);
  for (std::uint32_t i = 0; i < wire.balls._length; ++i) {
    message.balls.push_back(read_ball(wire.balls._buffer[i]));
  }
  message.obstacles.reserve(wire.obstacles._length);
  for (std::uint32_t i = 0; i < wire.obstacles._length; ++i) {
    message.obstacles.push_back(read_obstacle(wire.obstacles._buffer[i]));
  }
  return message;
}

template <>
std::optional<Reject> to_wire(const LinePoints& message, WireSample<LinePoints>& out) {
  Encoding encoding;
  if (!encoding.fits(message.points.size(), kMaxLinePoints)) return encoding.broken();
  teamsight_v1_LinePoints& wire = out.sample;
  wire.robot_id = message.id.robot;
  wire.sample = to_wire(message.id);
  wire.exposure_ns = nanoseconds(message.exposure);
  for (std::size_t i = 0; i < message.points.size(); ++i) {
    const LinePoint& from = message.points[i];
    out.storage[i] = {encoding.signed_steps(from.p_R.x, kMillimetre),
                      encoding.signed_steps(from.p_R.y, kMillimetre),
                      octet(from.inlier)};
  }
  lend(out.storage, message.points.size(), wire.points);
  return encoding.broken() ? encoding.broken() : broken_rule(wire);
}

template <>
Result<LinePoints, Reject> from_wire<LinePoints>(const teamsight_v1_LinePoints& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  LinePoints message;
  message.id = from_wire(wire.sample);
  message.exposure = peer_time(wire.exposure_ns);
  message.points.reserve(wire.points._length);
  for (std::uint32_t i = 0; i < wire.points._length; ++i) {
    const teamsight_v1_LinePoint& from = wire.points._buffer[i];
    message.points.push_back(
        {Point<Robot>{from.x_mm * kMillimetre, from.y_mm * kMillimetre}, from.inlier != 0});
  }
  return message;
}

template <>
std::optional<Reject> to_wire(const Thumbnail& message, WireSample<Thumbnail>& out) {
  Encoding encoding;
  if (!encoding.fits(message.jpeg.size(), kMaxJpeg)) return encoding.broken();
  teamsight_v1_Thumbnail& wire = out.sample;
  wire.robot_id = message.id.robot;
  wire.sample = to_wire(message.id);
  wire.exposure_ns = nanoseconds(message.exposure);
  wire.width_px = message.width_px;
  wire.height_px = message.height_px;
  out.storage = message.jpeg;  // keeps its memory from one write to the next
  lend(out.storage, message.jpeg.size(), wire.jpeg);
  return broken_rule(wire);
}

template <>
Result<Thumbnail, Reject> from_wire<Thumbnail>(const teamsight_v1_Thumbnail& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  Thumbnail message;
  message.id = from_wire(wire.sample);
  message.exposure = peer_time(wire.exposure_ns);
  message.width_px = wire.width_px;
  message.height_px = wire.height_px;
  message.jpeg.assign(wire.jpeg._buffer, wire.jpeg._buffer + wire.jpeg._length);
  return message;
}

}  // namespace teamsight::bus
