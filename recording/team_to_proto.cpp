// recording/team_to_proto.cpp: the topics of recording/to_proto.hpp that every process writes.
#include "recording/proto_parts.hpp"
#include "recording/to_proto.hpp"

namespace teamsight::recording {

using parts::set;
using parts::to_ms;
using parts::to_ns;

void to_proto(const bus::ClockProbe& from, v1::ClockProbe& to) {
  set(from.id, *to.mutable_sample());
  to.set_sent_ns(to_ns(from.sent));
}

void to_proto(const bus::ClockEcho& from, v1::ClockEcho& to) {
  set(from.id, *to.mutable_sample());
  to.set_sent_ns(to_ns(from.sent));
  for (const bus::ClockReply& reply : from.replies) {
    v1::ClockReply& entry = *to.add_replies();
    set(reply.probe, *entry.mutable_probe());
    entry.set_received_ns(to_ns(reply.received));
  }
}

void to_proto(const bus::GameState& from, v1::GameState& to) {
  set(from.id, *to.mutable_sample());
  to.set_stamp_ns(to_ns(from.stamp));
  to.set_phase(static_cast<std::uint32_t>(from.phase));
  to.set_piece(static_cast<std::uint32_t>(from.piece));
  to.set_piece_is_ours(from.piece_is_ours);
  to.set_running(from.running);
  to.set_goals_own(from.goals_own);
  to.set_goals_opponent(from.goals_opponent);
  to.set_box_connected(from.box_connected);
  to.set_command_age_ms(to_ms(from.command_age));
}

void to_proto(const bus::Command& from, v1::Command& to) {
  set(from.id, *to.mutable_sample());
  to.set_target_robot_id(from.target);
  to.set_command_id(from.command);
  to.set_kind(static_cast<std::uint32_t>(from.kind));
  set(from.X_FR, from.cov, *to.mutable_posture());
  to.set_duration_ms(to_ms(from.duration));
}

void to_proto(const bus::Diagnostics& from, v1::Diagnostics& to) {
  to.set_process(from.process);
  set(from.id, *to.mutable_sample());
  to.set_stamp_ns(to_ns(from.stamp));
  to.set_healthy(from.healthy);
  to.set_message(from.message);
  to.set_frame_age_ms(from.frame_age_ms);
  to.set_step_ms_p50(from.step_ms_p50);
  to.set_step_ms_p95(from.step_ms_p95);
  to.set_cpu_load(from.cpu_load);
  to.set_resident_kb(from.resident_kb);
  to.set_wire_bps(from.wire_bps);
  to.set_thrift(from.thrift);
  to.set_secured(from.secured);
  for (const bus::Counter& counter : from.counters) set(counter, *to.add_counters());
}

void to_proto(const bus::Truth& from, v1::Truth& to) {
  set(from.id, *to.mutable_sample());
  to.set_stamp_ns(to_ns(from.stamp));
  set(from.p_FB, *to.mutable_ball_p_m());
  set(from.v_FB, *to.mutable_ball_v_mps());
  for (const bus::TrueRobot& robot : from.robots) {
    v1::TrueRobot& entry = *to.add_robots();
    entry.set_robot_id(robot.robot);
    entry.set_x_m(robot.X_FR.x());
    entry.set_y_m(robot.X_FR.y());
    entry.set_theta_rad(robot.X_FR.theta());
    entry.set_vx_mps(robot.v_FR.x);
    entry.set_vy_mps(robot.v_FR.y);
  }
}

}  // namespace teamsight::recording
