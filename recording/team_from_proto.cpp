// recording/team_from_proto.cpp: the topics of recording/from_proto.hpp that every process writes.
#include "recording/from_proto.hpp"
#include "recording/proto_values.hpp"

namespace teamsight::recording {

using parts::Decoding;
using parts::set;
using parts::stamp;

namespace {

bus::ExplainedTrack track(const v1::ExplainedTrack& from, Decoding& decoding) {
  bus::ExplainedTrack to;
  to.track = from.track_id();
  decoding.require(from.kind() == "ball" || from.kind() == "obstacle");
  to.kind = from.kind() == "ball" ? bus::TrackKind::kBall : bus::TrackKind::kObstacle;
  to.supporters = decoding.narrow<RobotMask>(from.supporters());
  to.rejected = decoding.narrow<RobotMask>(from.rejected());
  to.born_ago = std::chrono::seconds(from.born_s_ago());
  to.nis = from.nis();
  return to;
}

bus::ExplainedRobot robot(const v1::ExplainedRobot& from, Decoding& decoding) {
  return {decoding.narrow<RobotId>(from.robot_id()),
          from.trust(),
          decoding.code(from.quarantine(), Quarantine::kDuplicateId),
          from.accepted(),
          from.rejected_gate(),
          from.rejected_late(),
          from.rejected_duplicate(),
          from.rejected_posture(),
          decoding.from_ms(from.clock_offset_ms()),
          decoding.from_ms(from.clock_sigma_ms())};
}

bus::Explanation value(const v1::Explanation& from, Decoding& decoding) {
  bus::Explanation to{decoding.id(from.sample()), stamp(from.stamp_ns()), {}, {}, {}};
  for (const auto& entry : from.tracks()) to.tracks.push_back(track(entry, decoding));
  for (const auto& entry : from.robots()) to.robots.push_back(robot(entry, decoding));
  to.hint = {
      from.hint().command_id(), from.hint().track_id(), decoding.from_ms(from.hint().left_ms())};
  return to;
}

bus::ClockProbe value(const v1::ClockProbe& from, Decoding& decoding) {
  return {decoding.id(from.sample()), stamp(from.sent_ns())};
}

bus::ClockEcho value(const v1::ClockEcho& from, Decoding& decoding) {
  bus::ClockEcho to{decoding.id(from.sample()), stamp(from.sent_ns()), {}};
  for (const auto& entry : from.replies()) {
    to.replies.push_back({decoding.id(entry.probe()), stamp(entry.received_ns())});
  }
  return to;
}

bus::GameState value(const v1::GameState& from, Decoding& decoding) {
  bus::GameState to;
  to.id = decoding.id(from.sample());
  to.stamp = stamp(from.stamp_ns());
  to.phase = decoding.code(from.phase(), bus::GamePhase::kShootout);
  to.piece = decoding.code(from.piece(), bus::SetPiece::kPark);
  to.piece_is_ours = from.piece_is_ours();
  to.running = from.running();
  to.goals_own = decoding.narrow<std::uint8_t>(from.goals_own());
  to.goals_opponent = decoding.narrow<std::uint8_t>(from.goals_opponent());
  to.box_connected = from.box_connected();
  to.command_age = decoding.from_ms(from.command_age_ms());
  return to;
}

bus::Command value(const v1::Command& from, Decoding& decoding) {
  bus::Command to;
  to.id = decoding.id(from.sample());
  to.target = decoding.narrow<RobotId>(from.target_robot_id());
  to.command = from.command_id();
  to.kind = decoding.code(from.kind(), bus::CommandKind::kThumbnail);
  to.X_FR = decoding.pose(from.posture());
  to.cov = decoding.cov<3>(from.posture().cov());
  to.duration = decoding.from_ms(from.duration_ms());
  return to;
}

bus::Diagnostics value(const v1::Diagnostics& from, Decoding& decoding) {
  bus::Diagnostics to;
  to.process = from.process();
  to.id = decoding.id(from.sample());
  to.stamp = stamp(from.stamp_ns());
  to.healthy = from.healthy();
  to.message = from.message();
  to.frame_age_ms = from.frame_age_ms();
  to.step_ms_p50 = from.step_ms_p50();
  to.step_ms_p95 = from.step_ms_p95();
  to.cpu_load = from.cpu_load();
  to.resident_kb = from.resident_kb();
  to.wire_bps = from.wire_bps();
  to.thrift = decoding.narrow<std::uint8_t>(from.thrift());
  to.secured = from.secured();
  for (const auto& entry : from.counters()) to.counters.push_back({entry.name(), entry.value()});
  return to;
}

bus::Truth value(const v1::Truth& from, Decoding& decoding) {
  bus::Truth to;
  to.id = decoding.id(from.sample());
  to.stamp = stamp(from.stamp_ns());
  set(from.ball_p_m(), to.p_FB);
  set(from.ball_v_mps(), to.v_FB);
  for (const auto& entry : from.robots()) {
    to.robots.push_back({decoding.narrow<std::uint8_t>(entry.robot_id()),
                         decoding.pose(entry),
                         {entry.vx_mps(), entry.vy_mps()}});
  }
  return to;
}

}  // namespace

template <>
std::optional<bus::Explanation> from_payload(std::string_view payload) {
  return parts::decode<bus::Explanation>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<bus::ClockProbe> from_payload(std::string_view payload) {
  return parts::decode<bus::ClockProbe>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<bus::ClockEcho> from_payload(std::string_view payload) {
  return parts::decode<bus::ClockEcho>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<bus::GameState> from_payload(std::string_view payload) {
  return parts::decode<bus::GameState>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<bus::Command> from_payload(std::string_view payload) {
  return parts::decode<bus::Command>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<bus::Diagnostics> from_payload(std::string_view payload) {
  return parts::decode<bus::Diagnostics>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

template <>
std::optional<bus::Truth> from_payload(std::string_view payload) {
  return parts::decode<bus::Truth>(
      payload, [](const auto& from, Decoding& decoding) { return value(from, decoding); });
}

}  // namespace teamsight::recording
