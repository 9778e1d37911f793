// bus/wire_world.cpp: the wire form of the world model.
#include "bus/wire.hpp"
#include "bus/wire_check.hpp"
#include "bus/wire_convert.hpp"

namespace teamsight::bus {
namespace {

constexpr double kMillimetre = 0.001;

void check_ball(WireCheck& check, const teamsight_v1_WorldBall& ball) {
  for (int i = 0; i < 3; ++i) {
    check.within(ball.p_m[i], kLargestDistance);
    check.within(ball.v_mps[i], kLargestSpeed);
  }
  check.covariance(ball.cov_p, 3);
  check.covariance(ball.cov_v, 3);
  check.percent(ball.existence_percent);
}

void check_teammate(WireCheck& check, const teamsight_v1_WorldTeammate& mate) {
  check.require(mate.robot_id != kNobody && mate.robot_id <= kMaxRobotId, Reject::kBadIdentity);
  check.code(mate.status, static_cast<std::uint8_t>(PostureStatus::kOk));
  check.posture(mate.posture);
  check.within(mate.vx_mps, kLargestSpeed);
  check.within(mate.vy_mps, kLargestSpeed);
  check.within(mate.half_log_odds, kLargestLogOdds);
  check.within(mate.half_log_odds_team, kLargestLogOdds);
  check.percent(mate.trust_percent);
  check.code(mate.quarantine, static_cast<std::uint8_t>(Quarantine::kDuplicateId));
  check.flag(mate.sees_ball);
}

void check_obstacle(WireCheck& check, const teamsight_v1_WorldObstacle& obstacle) {
  check.within(obstacle.x_m, kLargestDistance);
  check.within(obstacle.y_m, kLargestDistance);
  check.within(obstacle.vx_mps, kLargestSpeed);
  check.within(obstacle.vy_mps, kLargestSpeed);
  check.covariance(obstacle.cov, 2);
  check.percent(obstacle.existence_percent);
}

std::optional<Reject> broken_rule(const teamsight_v1_WorldModel& wire) {
  WireCheck check;
  check.team_sample(wire.team, wire.sample);
  check.stamp(wire.stamp_ns);
  if (!check.sequence(wire.balls, kMaxWorldBalls)) return check.broken();
  if (!check.sequence(wire.teammates, kMaxWorldTeammates)) return check.broken();
  if (!check.sequence(wire.obstacles, kMaxWorldObstacles)) return check.broken();
  for (std::uint32_t i = 0; i < wire.balls._length; ++i) check_ball(check, wire.balls._buffer[i]);
  for (std::uint32_t i = 0; i < wire.teammates._length; ++i) {
    check_teammate(check, wire.teammates._buffer[i]);
  }
  for (std::uint32_t i = 0; i < wire.obstacles._length; ++i) {
    check_obstacle(check, wire.obstacles._buffer[i]);
  }
  return check.broken();
}

teamsight_v1_WorldBall write_ball(const WorldBall& from, Encoding& encoding) {
  teamsight_v1_WorldBall to{};
  to.track_id = from.track;
  for (int i = 0; i < 3; ++i) {
    to.p_m[i] = single(from.p_FB.vector()[i]);
    to.v_mps[i] = single(from.v_FB.vector()[i]);
  }
  write_triangle<3>(from.cov_p, to.cov_p);
  write_triangle<3>(from.cov_v, to.cov_v);
  to.existence_percent = encoding.percent(from.existence);
  to.age_ms = encoding.age_ms(from.age);
  to.supporters = from.supporters;
  to.rejected = from.rejected;
  return to;
}

WorldBall read_ball(const teamsight_v1_WorldBall& from) {
  WorldBall to;
  to.track = from.track_id;
  to.p_FB = {static_cast<double>(from.p_m[0]),
             static_cast<double>(from.p_m[1]),
             static_cast<double>(from.p_m[2])};
  to.v_FB = {static_cast<double>(from.v_mps[0]),
             static_cast<double>(from.v_mps[1]),
             static_cast<double>(from.v_mps[2])};
  to.cov_p = symmetric<3>(from.cov_p);
  to.cov_v = symmetric<3>(from.cov_v);
  to.existence = share(from.existence_percent);
  to.age = milliseconds(from.age_ms);
  to.supporters = from.supporters;
  to.rejected = from.rejected;
  return to;
}

teamsight_v1_WorldTeammate write_teammate(const WorldTeammate& from, Encoding& encoding) {
  teamsight_v1_WorldTeammate to{};
  to.robot_id = from.robot;
  to.status = static_cast<std::uint8_t>(from.status);
  to.posture = to_wire(from.X_FR, from.cov);
  to.vx_mps = single(from.v_FR.x);
  to.vy_mps = single(from.v_FR.y);
  to.half_log_odds = single(from.half_log_odds);
  to.half_log_odds_team = single(from.half_log_odds_team);
  to.frame = from.frame;
  to.age_ms = encoding.age_ms(from.age);
  to.trust_percent = encoding.percent(from.trust);
  to.quarantine = static_cast<std::uint8_t>(from.quarantine);
  to.sees_ball = octet(from.sees_ball);
  return to;
}

WorldTeammate read_teammate(const teamsight_v1_WorldTeammate& from) {
  WorldTeammate to;
  to.robot = from.robot_id;
  to.status = static_cast<PostureStatus>(from.status);
  to.X_FR = pose_from_wire(from.posture);
  to.v_FR = {static_cast<double>(from.vx_mps), static_cast<double>(from.vy_mps)};
  to.cov = symmetric<3>(from.posture.cov);
  to.half_log_odds = static_cast<double>(from.half_log_odds);
  to.half_log_odds_team = static_cast<double>(from.half_log_odds_team);
  to.frame = from.frame;
  to.age = milliseconds(from.age_ms);
  to.trust = share(from.trust_percent);
  to.quarantine = static_cast<Quarantine>(from.quarantine);
  to.sees_ball = from.sees_ball != 0;
  return to;
}

teamsight_v1_WorldObstacle write_obstacle(const WorldObstacle& from, Encoding& encoding) {
  teamsight_v1_WorldObstacle to{};
  to.track_id = from.track;
  to.x_m = single(from.p_FO.x);
  to.y_m = single(from.p_FO.y);
  to.vx_mps = single(from.v_FO.x);
  to.vy_mps = single(from.v_FO.y);
  write_triangle<2>(from.cov_p, to.cov);
  to.radius_mm = encoding.unsigned_steps(from.radius, kMillimetre);
  to.age_ms = encoding.age_ms(from.age);
  to.supporters = from.supporters;
  to.existence_percent = encoding.percent(from.existence);
  return to;
}

WorldObstacle read_obstacle(const teamsight_v1_WorldObstacle& from) {
  WorldObstacle to;
  to.track = from.track_id;
  to.p_FO = {static_cast<double>(from.x_m), static_cast<double>(from.y_m)};
  to.v_FO = {static_cast<double>(from.vx_mps), static_cast<double>(from.vy_mps)};
  to.cov_p = symmetric<2>(from.cov);
  to.radius = from.radius_mm * kMillimetre;
  to.existence = share(from.existence_percent);
  to.age = milliseconds(from.age_ms);
  to.supporters = from.supporters;
  return to;
}

bool lists_fit(const WorldModel& message, Encoding& encoding) {
  return encoding.fits(message.balls.size(), kMaxWorldBalls) &&
         encoding.fits(message.teammates.size(), kMaxWorldTeammates) &&
         encoding.fits(message.obstacles.size(), kMaxWorldObstacles);
}

}  // namespace

template <>
const dds_topic_descriptor_t& topic_descriptor<WorldModel>() noexcept {
  return teamsight_v1_WorldModel_desc;
}

template <>
std::optional<Reject> to_wire(const WorldModel& message, WireSample<WorldModel>& out) {
  Encoding encoding;
  if (!lists_fit(message, encoding)) return encoding.broken();
  teamsight_v1_WorldModel& wire = out.sample;
  wire.team = 0;
  wire.sample = to_wire(message.id);
  wire.strength = message.strength;
  wire.stamp_ns = nanoseconds(message.stamp);
  for (std::size_t i = 0; i < message.balls.size(); ++i) {
    out.storage.balls[i] = write_ball(message.balls[i], encoding);
  }
  for (std::size_t i = 0; i < message.teammates.size(); ++i) {
    out.storage.teammates[i] = write_teammate(message.teammates[i], encoding);
  }
  for (std::size_t i = 0; i < message.obstacles.size(); ++i) {
    out.storage.obstacles[i] = write_obstacle(message.obstacles[i], encoding);
  }
  lend(out.storage.balls, message.balls.size(), wire.balls);
  lend(out.storage.teammates, message.teammates.size(), wire.teammates);
  lend(out.storage.obstacles, message.obstacles.size(), wire.obstacles);
  return encoding.broken() ? encoding.broken() : broken_rule(wire);
}

template <>
Result<WorldModel, Reject> from_wire<WorldModel>(const teamsight_v1_WorldModel& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  WorldModel message;
  message.id = from_wire(wire.sample);
  message.strength = wire.strength;
  message.stamp = peer_time(wire.stamp_ns);
  message.balls.reserve(wire.balls._length);
  for (std::uint32_t i = 0; i < wire.balls._length; ++i) {
    message.balls.push_back(read_ball(wire.balls._buffer[i]));
  }
  message.teammates.reserve(wire.teammates._length);
  for (std::uint32_t i = 0; i < wire.teammates._length; ++i) {
    message.teammates.push_back(read_teammate(wire.teammates._buffer[i]));
  }
  message.obstacles.reserve(wire.obstacles._length);
  for (std::uint32_t i = 0; i < wire.obstacles._length; ++i) {
    message.obstacles.push_back(read_obstacle(wire.obstacles._buffer[i]));
  }
  return message;
}

}  // namespace teamsight::bus
