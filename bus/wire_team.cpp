// bus/wire_team.cpp: the wire forms of explanations, clocks and diagnostics.
#include <limits>

#include "bus/wire.hpp"
#include "bus/wire_check.hpp"
#include "bus/wire_convert.hpp"

namespace teamsight::bus {
namespace {

constexpr std::uint32_t kMaxTracks = 14;
constexpr std::uint32_t kMaxRobots = 16;
constexpr std::uint32_t kMaxReplies = 16;
constexpr std::uint32_t kMaxCounters = 18;

void check_robot(WireCheck& check, const teamsight_v1_ExplainedRobot& robot) {
  check.require(robot.robot_id != kNobody && robot.robot_id <= kMaxRobotId, Reject::kBadIdentity);
  check.percent(robot.trust_percent);
  check.code(robot.quarantine, static_cast<std::uint8_t>(Quarantine::kDuplicateId));
  check.require(
      std::abs(static_cast<double>(robot.clock_offset_ns)) <= static_cast<double>(kLargestStamp),
      Reject::kOutOfRange);
  check.between(robot.clock_sigma_ms, 0.0, 1e9);
}

std::optional<Reject> broken_rule(const teamsight_v1_Explanation& wire) {
  WireCheck check;
  check.team_sample(wire.team, wire.sample);
  check.stamp(wire.stamp_ns);
  if (!check.sequence(wire.tracks, kMaxTracks)) return check.broken();
  if (!check.sequence(wire.robots, kMaxRobots)) return check.broken();
  for (std::uint32_t i = 0; i < wire.tracks._length; ++i) {
    check.code(wire.tracks._buffer[i].kind, static_cast<std::uint8_t>(TrackKind::kObstacle));
    check.between(wire.tracks._buffer[i].nis, 0.0, 1e9);
  }
  for (std::uint32_t i = 0; i < wire.robots._length; ++i) {
    check_robot(check, wire.robots._buffer[i]);
  }
  return check.broken();
}

std::optional<Reject> broken_rule(const teamsight_v1_ClockProbe& wire) {
  WireCheck check;
  check.host_sample(wire.host_id, wire.sample);
  check.stamp(wire.sent_ns);
  return check.broken();
}

std::optional<Reject> broken_rule(const teamsight_v1_ClockEcho& wire) {
  WireCheck check;
  check.host_sample(wire.host_id, wire.sample);
  check.stamp(wire.sent_ns);
  if (!check.sequence(wire.replies, kMaxReplies)) return check.broken();
  for (std::uint32_t i = 0; i < wire.replies._length; ++i) {
    const teamsight_v1_ClockReply& reply = wire.replies._buffer[i];
    check.sample_id({reply.asker_host_id, reply.asker_boot_id, reply.probe_sequence});
    check.stamps(reply.received_ns, wire.sent_ns);
  }
  return check.broken();
}

std::optional<Reject> broken_rule(const teamsight_v1_Diagnostics& wire) {
  constexpr double kLongest = 1e9;  // ms, eleven days
  WireCheck check;
  check.sample_id(wire.sample);
  check.text(wire.process, sizeof wire.process);
  check.require(wire.process[0] != '\0', Reject::kBadIdentity);
  check.stamp(wire.stamp_ns);
  check.flag(wire.healthy);
  check.text(wire.message, sizeof wire.message);
  check.between(wire.frame_age_ms, -1.0, kLongest);
  check.between(wire.step_ms_p50, 0.0, kLongest);
  check.between(wire.step_ms_p95, 0.0, kLongest);
  check.between(wire.cpu_load, 0.0, 1000.0);
  check.between(wire.wire_bps, 0.0, 1e12);
  check.between(wire.thrift, 0.0, 4.0);
  check.flag(wire.secured);
  if (!check.sequence(wire.counters, kMaxCounters)) return check.broken();
  for (std::uint32_t i = 0; i < wire.counters._length; ++i) {
    check.text(wire.counters._buffer[i].name, sizeof wire.counters._buffer[i].name);
  }
  return check.broken();
}

std::uint16_t whole_seconds(std::chrono::seconds age, Encoding& encoding) {
  constexpr std::int64_t kMost = std::numeric_limits<std::uint16_t>::max();
  if (age.count() < 0) (void)encoding.long_ms(Duration{-1});
  return static_cast<std::uint16_t>(std::min(std::max<std::int64_t>(age.count(), 0), kMost));
}

teamsight_v1_ExplainedTrack write_track(const ExplainedTrack& from, Encoding& encoding) {
  teamsight_v1_ExplainedTrack to{};
  to.track_id = from.track;
  to.kind = static_cast<std::uint8_t>(from.kind);
  to.supporters = from.supporters;
  to.rejected = from.rejected;
  to.born_s_ago = whole_seconds(from.born_ago, encoding);
  to.nis = single(from.nis);
  return to;
}

ExplainedTrack read_track(const teamsight_v1_ExplainedTrack& from) {
  return {from.track_id,
          static_cast<TrackKind>(from.kind),
          from.supporters,
          from.rejected,
          std::chrono::seconds(from.born_s_ago),
          static_cast<double>(from.nis)};
}

teamsight_v1_ExplainedRobot write_robot(const ExplainedRobot& from, Encoding& encoding) {
  teamsight_v1_ExplainedRobot to{};
  to.robot_id = from.robot;
  to.trust_percent = encoding.percent(from.trust);
  to.quarantine = static_cast<std::uint8_t>(from.quarantine);
  to.accepted = from.accepted;
  to.rejected_gate = from.rejected_gate;
  to.rejected_late = from.rejected_late;
  to.rejected_duplicate = from.rejected_duplicate;
  to.rejected_posture = from.rejected_posture;
  to.clock_offset_ns = from.clock_offset.count();
  to.clock_sigma_ms = single(to_seconds(from.clock_sigma) * 1000.0);
  return to;
}

ExplainedRobot read_robot(const teamsight_v1_ExplainedRobot& from) {
  ExplainedRobot to;
  to.robot = from.robot_id;
  to.trust = share(from.trust_percent);
  to.quarantine = static_cast<Quarantine>(from.quarantine);
  to.accepted = from.accepted;
  to.rejected_gate = from.rejected_gate;
  to.rejected_late = from.rejected_late;
  to.rejected_duplicate = from.rejected_duplicate;
  to.rejected_posture = from.rejected_posture;
  to.clock_offset = Duration{from.clock_offset_ns};
  to.clock_sigma = from_seconds(static_cast<double>(from.clock_sigma_ms) / 1000.0);
  return to;
}

}  // namespace

template <>
const dds_topic_descriptor_t& topic_descriptor<Explanation>() noexcept {
  return teamsight_v1_Explanation_desc;
}

template <>
const dds_topic_descriptor_t& topic_descriptor<ClockProbe>() noexcept {
  return teamsight_v1_ClockProbe_desc;
}

template <>
const dds_topic_descriptor_t& topic_descriptor<ClockEcho>() noexcept {
  return teamsight_v1_ClockEcho_desc;
}

template <>
const dds_topic_descriptor_t& topic_descriptor<Diagnostics>() noexcept {
  return teamsight_v1_Diagnostics_desc;
}

template <>
std::optional<Reject> to_wire(const Explanation& message, WireSample<Explanation>& out) {
  Encoding encoding;
  if (!encoding.fits(message.tracks.size(), kMaxTracks)) return encoding.broken();
  if (!encoding.fits(message.robots.size(), kMaxRobots)) return encoding.broken();
  teamsight_v1_Explanation& wire = out.sample;
  wire.team = 0;
  wire.sample = to_wire(message.id);
  wire.stamp_ns = nanoseconds(message.stamp);
  for (std::size_t i = 0; i < message.tracks.size(); ++i) {
    out.storage.tracks[i] = write_track(message.tracks[i], encoding);
  }
  for (std::size_t i = 0; i < message.robots.size(); ++i) {
    out.storage.robots[i] = write_robot(message.robots[i], encoding);
  }
  lend(out.storage.tracks, message.tracks.size(), wire.tracks);
  lend(out.storage.robots, message.robots.size(), wire.robots);
  wire.hint_command_id = message.hint.command;
  wire.hint_track_id = message.hint.track;
  wire.hint_left_ms = encoding.age_ms(message.hint.left);
  return encoding.broken() ? encoding.broken() : broken_rule(wire);
}

template <>
Result<Explanation, Reject> from_wire<Explanation>(const teamsight_v1_Explanation& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  Explanation message;
  message.id = from_wire(wire.sample);
  message.stamp = peer_time(wire.stamp_ns);
  message.tracks.reserve(wire.tracks._length);
  for (std::uint32_t i = 0; i < wire.tracks._length; ++i) {
    message.tracks.push_back(read_track(wire.tracks._buffer[i]));
  }
  message.robots.reserve(wire.robots._length);
  for (std::uint32_t i = 0; i < wire.robots._length; ++i) {
    message.robots.push_back(read_robot(wire.robots._buffer[i]));
  }
  message.hint = {
      wire.hint_command_id, wire.hint_track_id, std::chrono::milliseconds(wire.hint_left_ms)};
  return message;
}

template <>
std::optional<Reject> to_wire(const ClockProbe& message, WireSample<ClockProbe>& out) {
  out.sample.host_id = message.id.robot;
  out.sample.sample = to_wire(message.id);
  out.sample.sent_ns = nanoseconds(message.sent);
  return broken_rule(out.sample);
}

template <>
Result<ClockProbe, Reject> from_wire<ClockProbe>(const teamsight_v1_ClockProbe& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  return ClockProbe{from_wire(wire.sample), peer_time(wire.sent_ns)};
}

template <>
std::optional<Reject> to_wire(const ClockEcho& message, WireSample<ClockEcho>& out) {
  Encoding encoding;
  if (!encoding.fits(message.replies.size(), kMaxReplies)) return encoding.broken();
  out.sample.host_id = message.id.robot;
  out.sample.sample = to_wire(message.id);
  out.sample.sent_ns = nanoseconds(message.sent);
  for (std::size_t i = 0; i < message.replies.size(); ++i) {
    const ClockReply& reply = message.replies[i];
    out.storage[i] = {
        reply.probe.robot, reply.probe.boot, reply.probe.sequence, nanoseconds(reply.received)};
  }
  lend(out.storage, message.replies.size(), out.sample.replies);
  return broken_rule(out.sample);
}

template <>
Result<ClockEcho, Reject> from_wire<ClockEcho>(const teamsight_v1_ClockEcho& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  ClockEcho message{from_wire(wire.sample), peer_time(wire.sent_ns), {}};
  message.replies.reserve(wire.replies._length);
  for (std::uint32_t i = 0; i < wire.replies._length; ++i) {
    const teamsight_v1_ClockReply& reply = wire.replies._buffer[i];
    message.replies.push_back(
        {ObservationId{reply.asker_host_id, reply.asker_boot_id, reply.probe_sequence},
         peer_time(reply.received_ns)});
  }
  return message;
}

template <>
std::optional<Reject> to_wire(const Diagnostics& message, WireSample<Diagnostics>& out) {
  Encoding encoding;
  if (!encoding.fits(message.counters.size(), kMaxCounters)) return encoding.broken();
  teamsight_v1_Diagnostics& wire = out.sample;
  encoding.text(message.process, wire.process, sizeof wire.process);
  wire.sample = to_wire(message.id);
  wire.stamp_ns = nanoseconds(message.stamp);
  wire.healthy = octet(message.healthy);
  encoding.text(message.message, wire.message, sizeof wire.message);
  wire.frame_age_ms = single(message.frame_age_ms);
  wire.step_ms_p50 = single(message.step_ms_p50);
  wire.step_ms_p95 = single(message.step_ms_p95);
  wire.cpu_load = single(message.cpu_load);
  wire.resident_kb = message.resident_kb;
  wire.wire_bps = single(message.wire_bps);
  wire.thrift = message.thrift;
  wire.secured = octet(message.secured);
  for (std::size_t i = 0; i < message.counters.size(); ++i) {
    teamsight_v1_Counter& to = out.storage[i];
    encoding.text(message.counters[i].name, to.name, sizeof to.name);
    to.value = message.counters[i].value;
  }
  lend(out.storage, message.counters.size(), wire.counters);
  return encoding.broken() ? encoding.broken() : broken_rule(wire);
}

template <>
Result<Diagnostics, Reject> from_wire<Diagnostics>(const teamsight_v1_Diagnostics& wire) {
  if (const auto broken = broken_rule(wire)) return failure(*broken);
  Diagnostics message;
  message.process = wire.process;
  message.id = from_wire(wire.sample);
  message.stamp = peer_time(wire.stamp_ns);
  message.healthy = wire.healthy != 0;
  message.message = wire.message;
  message.frame_age_ms = static_cast<double>(wire.frame_age_ms);
  message.step_ms_p50 = static_cast<double>(wire.step_ms_p50);
  message.step_ms_p95 = static_cast<double>(wire.step_ms_p95);
  message.cpu_load = static_cast<double>(wire.cpu_load);
  message.resident_kb = wire.resident_kb;
  message.wire_bps = static_cast<double>(wire.wire_bps);
  message.thrift = wire.thrift;
  message.secured = wire.secured != 0;
  message.counters.reserve(wire.counters._length);
  for (std::uint32_t i = 0; i < wire.counters._length; ++i) {
    message.counters.push_back({wire.counters._buffer[i].name, wire.counters._buffer[i].value});
  }
  return message;
}

}  // namespace teamsight::bus
