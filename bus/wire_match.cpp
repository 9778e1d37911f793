// bus/wire_match.cpp: the wire forms of the match: game state, commands, the simulator's truth.
#include "bus/wire.hpp"
#include "bus/wire_check.hpp"
#include "bus/wire_convert.hpp"

namespace teamsight::bus {
namespace {

constexpr std::uint32_t kMaxTrueRobots = 20;
constexpr std::uint8_t kLastTrueRobot = 32;

std::optional<Reject> broken_rule(const teamsight_v1_GameState& wire) {
  WireCheck check;
  check.team_sample(wire.team, wire.sample);
  check.stamp(wire.stamp_ns);
  check.enumerator(wire.phase, teamsight_v1_PHASE_SHOOTOUT);
  check.enumerator(wire.piece, teamsight_v1_PIECE_PARK);
  check.flag(wire.piece_is_ours);
  check.flag(wire.running);
  check.flag(wire.box_connected);
  return check.broken();
}

std::optional<Reject> broken_rule(const teamsight_v1_Command& wire) {
  WireCheck check;
  check.sample_id(wire.sample);
  check.require(wire.target_robot_id <= kMaxRobotId, Reject::kBadIdentity);
  check.require(wire.command_id != 0, Reject::kBadIdentity);
  check.enumerator(wire.kind, teamsight_v1_COMMAND_THUMBNAIL);
  check.posture(wire.posture);
  return check.broken();
}

std::optional<Reject> broken_rule(const teamsight_v1_Truth& wire) {
  WireCheck check;
  check.team_sample(wire.match, wire.sample);
  check.stamp(wire.stamp_ns);
  for (int i = 0; i < 3; ++i) {
    check.within(wire.ball_p_m[i], kLargestDistance);
    check.within(wire.ball_v_mps[i], kLargestSpeed);
  }
  if (!check.sequence(wire.robots, kMaxTrueRobots)) return check.broken();
  for (std::uint32_t i = 0; i < wire.robots._length; ++i) {
    const teamsight_v1_TrueRobot& robot = wire.robots._buffer[i];
    check.require(robot.robot_id >= 1 && robot.robot_id <= kLastTrueRobot, Reject::kBadIdentity);
    check.within(robot.x_m, kLargestDistance);
    check.within(robot.y_m, kLargestDistance);
    check.within(robot.theta_rad, kLargestAngle);
    check.within(robot.vx_mps, kLargestSpeed);
    check.within(robot.vy_mps, kLargestSpeed);
  }
  return check.broken();
}

}  // namespace

template <>
const dds_topic_descriptor_t& topic_descriptor<GameState>() noexcept {
  return teamsight_v1_GameState_desc;
}

template <>
const dds_topic_descriptor_t& topic_descriptor<Command>() noexcept {
  return teamsight_v1_Command_desc;
}

template <>
const dds_topic_descriptor_t& topic_descriptor<Truth>() noexcept {
  return teamsight_v1_Truth_desc;
}

template <>
std::optional<Reject> to_wire(const GameState& message, WireSample<GameState>& out) {
  Encoding encoding;
  teamsight_v1_GameState& wire = out.sample;
  wire.team = 0;
  wire.sample = to_wire(message.id);
  wire.stamp_ns = nanoseconds(message.stamp);
  wire.phase = static_cast<teamsight_v1_GamePhase>(message.phase);
  wire.piece = static_cast<teamsight_v1_SetPiece>(message.piece);
  wire.piece_is_ours = octet(message.piece_is_ours);
  wire.running = octet(message.running);
  wire.goals_own = message.goals_own;
  wire.goals_opponent = message.goals_opponent;
  wire.box_connected = octet(message.box_connected);
  wire.command_age_ms = encoding.long_ms(message.command_age);
  return encoding.broken() ? encoding.broken() : broken_rule(wire);
}

template <>
Result<GameState, Reject> from_wire<GameState>(const teamsight_v1_GameState& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  GameState message;
  message.id = from_wire(wire.sample);
  message.stamp = peer_time(wire.stamp_ns);
  message.phase = static_cast<GamePhase>(wire.phase);
  message.piece = static_cast<SetPiece>(wire.piece);
  message.piece_is_ours = wire.piece_is_ours != 0;
  message.running = wire.running != 0;
  message.goals_own = wire.goals_own;
  message.goals_opponent = wire.goals_opponent;
  message.box_connected = wire.box_connected != 0;
  message.command_age = milliseconds(wire.command_age_ms);
  return message;
}

template <>
std::optional<Reject> to_wire(const Command& message, WireSample<Command>& out) {
  Encoding encoding;
  teamsight_v1_Command& wire = out.sample;
  wire.target_robot_id = message.target;
  wire.sample = to_wire(message.id);
  wire.command_id = message.command;
  wire.kind = static_cast<teamsight_v1_CommandKind>(message.kind);
  wire.posture = to_wire(message.X_FR, message.cov);
  wire.duration_ms = encoding.long_ms(message.duration);
  return encoding.broken() ? encoding.broken() : broken_rule(wire);
}

template <>
Result<Command, Reject> from_wire<Command>(const teamsight_v1_Command& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  Command message;
  message.id = from_wire(wire.sample);
  message.target = wire.target_robot_id;
  message.command = wire.command_id;
  message.kind = static_cast<CommandKind>(wire.kind);
  message.X_FR = pose_from_wire(wire.posture);
  message.cov = symmetric<3>(wire.posture.cov);
  message.duration = milliseconds(wire.duration_ms);
  return message;
}

template <>
std::optional<Reject> to_wire(const Truth& message, WireSample<Truth>& out) {
  Encoding encoding;
  if (!encoding.fits(message.robots.size(), kMaxTrueRobots)) return encoding.broken();
  teamsight_v1_Truth& wire = out.sample;
  wire.match = 0;
  wire.sample = to_wire(message.id);
  wire.stamp_ns = nanoseconds(message.stamp);
  for (int i = 0; i < 3; ++i) {
    wire.ball_p_m[i] = single(message.p_FB.vector()[i]);
    wire.ball_v_mps[i] = single(message.v_FB.vector()[i]);
  }
  for (std::size_t i = 0; i < message.robots.size(); ++i) {
    const TrueRobot& from = message.robots[i];
    out.storage[i] = {from.robot,
                      single(from.X_FR.x()),
                      single(from.X_FR.y()),
                      single(from.X_FR.theta()),
                      single(from.v_FR.x),
                      single(from.v_FR.y)};
  }
  lend(out.storage, message.robots.size(), wire.robots);
  return broken_rule(wire);
}

template <>
Result<Truth, Reject> from_wire<Truth>(const teamsight_v1_Truth& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  Truth message;
  message.id = from_wire(wire.sample);
  message.stamp = peer_time(wire.stamp_ns);
  message.p_FB = {static_cast<double>(wire.ball_p_m[0]),
                  static_cast<double>(wire.ball_p_m[1]),
                  static_cast<double>(wire.ball_p_m[2])};
  message.v_FB = {static_cast<double>(wire.ball_v_mps[0]),
                  static_cast<double>(wire.ball_v_mps[1]),
                  static_cast<double>(wire.ball_v_mps[2])};
  message.robots.reserve(wire.robots._length);
  for (std::uint32_t i = 0; i < wire.robots._length; ++i) {
    const teamsight_v1_TrueRobot& from = wire.robots._buffer[i];
    message.robots.push_back(
        {from.robot_id,
         Pose<Field, Robot>(static_cast<double>(from.x_m),
                            static_cast<double>(from.y_m),
                            static_cast<double>(from.theta_rad)),
         Velocity<Field>{static_cast<double>(from.vx_mps), static_cast<double>(from.vy_mps)}});
  }
  return message;
}

}  // namespace teamsight::bus
