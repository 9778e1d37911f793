// monitor/update_to_proto.cpp: see monitor/update_to_proto.hpp.
#include "monitor/update_to_proto.hpp"

#include "monitor.pb.h"
#include "recording/proto_parts.hpp"
#include "recording/to_proto.hpp"

namespace teamsight::monitor {

using recording::to_proto;
using recording::parts::set;
using recording::parts::to_ms;
using recording::parts::to_ns;

namespace {

void fill(const Point<Field>& from, const Point<Field>& until, v1::MonitorField::Line& to) {
  to.set_from_x_m(from.x);
  to.set_from_y_m(from.y);
  to.set_to_x_m(until.x);
  to.set_to_y_m(until.y);
}

const char* name_of(Level level) {
  switch (level) {
    case Level::kInfo:
      return "info";
    case Level::kWarning:
      return "warning";
    case Level::kAlarm:
      return "alarm";
  }
  return "info";
}

void fill(const RobotRow& from, v1::RobotRow& to) {
  to.set_robot_id(from.robot);
  to.set_alive(from.alive);
  to.set_age_ms(to_ms(from.age));
  to.set_rate_hz(from.link.rate);
  to.set_loss(from.link.loss);
  to.set_latency_p50_ms(from.link.latency_p50 ? to_ms(*from.link.latency_p50) : -1.0);
  to.set_latency_p95_ms(from.link.latency_p95 ? to_ms(*from.link.latency_p95) : -1.0);
  to.set_received(from.link.received);
  to.set_duplicate(from.duplicate);
  to.set_other_version(from.other_version);
  if (from.state) to_proto(*from.state, *to.mutable_state());
  if (from.agent) to_proto(*from.agent, *to.mutable_agent());
  if (from.explained) set(*from.explained, *to.mutable_explained());
  if (from.sightings) to_proto(*from.sightings, *to.mutable_sightings());
  if (from.line_points) to_proto(*from.line_points, *to.mutable_line_points());
  if (from.sensors) to_proto(*from.sensors, *to.mutable_sensors());
}

const char* name_of(ActionState state) {
  switch (state) {
    case ActionState::kWaiting:
      return "waiting";
    case ActionState::kDone:
      return "done";
    case ActionState::kNoAnswer:
      return "no answer";
  }
  return "waiting";
}

void fill(const ActionReport& from, v1::MonitorAction& to) {
  to.set_command_id(from.command);
  to.set_text(from.text);
  to.set_state(name_of(from.state));
  to.set_age_ms(to_ms(from.age));
}

void fill(const RefereeReport& from, v1::RefereeReport& to) {
  to_proto(from.state, *to.mutable_state());
  to.set_last_command(from.last_command);
  to.set_has_box(from.has_box);
  to.set_world_state_hz(from.world_state_rate);
  to.set_world_states_skipped(from.world_states_skipped);
  to.set_refused(from.refused);
  to.set_tells_game(from.tells_game);
  to.set_follows_game(from.follows_game);
}

void fill(const recording::RecorderReport& from, v1::RecorderReport& to) {
  to.set_file(from.file);
  to.set_bytes(from.bytes);
  to.set_messages(from.messages);
  to.set_dropped(from.dropped);
  to.set_free_bytes(from.free_bytes);
  to.set_problem(from.problem);
}

}  // namespace

void to_proto(const FieldModel& from, v1::MonitorField& to) {
  to.set_name(from.name);
  to.set_length_m(from.length);
  to.set_width_m(from.width);
  to.set_surround_m(from.surround);
  to.set_line_width_m(from.line_width);
  to.set_centre_x_m(from.centre.x);
  to.set_centre_y_m(from.centre.y);
  for (const FieldLine& line : from.lines) fill(line.from, line.to, *to.add_lines());
  for (const Wall& wall : from.walls) fill(wall.from, wall.to, *to.add_walls());
  for (const FieldArc& arc : from.arcs) {
    v1::MonitorField::Arc& entry = *to.add_arcs();
    entry.set_centre_x_m(arc.centre.x);
    entry.set_centre_y_m(arc.centre.y);
    entry.set_radius_m(arc.radius);
    entry.set_start_rad(arc.start);
    entry.set_sweep_rad(arc.sweep);
  }
  for (const FieldSpot& spot : from.spots) {
    v1::MonitorField::Spot& entry = *to.add_spots();
    entry.set_x_m(spot.centre.x);
    entry.set_y_m(spot.centre.y);
    entry.set_radius_m(spot.radius);
  }
  for (const Goal& goal : from.goals) {
    v1::MonitorField::MonitorGoal& entry = *to.add_goals();
    fill(goal.left_post, goal.right_post, *entry.mutable_mouth());
    entry.set_depth_m(goal.depth);
    entry.set_colour(static_cast<std::uint32_t>(goal.colour));
  }
}

void to_proto(const Update& from, v1::MonitorUpdate& to) {
  to.set_stamp_ns(to_ns(stamp_of(from.stamp)));
  if (from.world) to_proto(*from.world, *to.mutable_world());
  to.set_world_age_ms(to_ms(from.world_age));
  for (const RobotRow& row : from.robots) fill(row, *to.add_robots());
  to.set_silence(from.silence);
  if (from.truth) to_proto(*from.truth, *to.mutable_truth());
  for (const bus::Diagnostics& process : from.processes) to_proto(process, *to.add_processes());
  for (const bus::Counter& counter : from.rejected) set(counter, *to.add_rejected());
  if (from.without) {
    to.mutable_without()->set_robot_id(from.without->robot);
    to_proto(from.without->world, *to.mutable_without()->mutable_world());
  }
  to.set_other_stations(from.other_stations);
  if (from.hint) to_proto(*from.hint, *to.mutable_hint());
  if (from.referee) fill(*from.referee, *to.mutable_referee());
  if (from.recorder) fill(*from.recorder, *to.mutable_recorder());
  for (const ActionReport& action : from.actions) fill(action, *to.add_actions());
}

void thumbnails_to_proto(const Update& from, v1::MonitorUpdate& to) {
  for (const bus::Thumbnail& picture : from.thumbnails) to_proto(picture, *to.add_thumbnails());
}

void events_to_proto(const Update& from, v1::MonitorUpdate& to) {
  for (const Event& event : from.events) {
    v1::MonitorEvent& entry = *to.add_events();
    entry.set_stamp_ns(to_ns(stamp_of(event.stamp)));
    entry.set_level(name_of(event.level));
    entry.set_text(event.text);
  }
}

}  // namespace teamsight::monitor
