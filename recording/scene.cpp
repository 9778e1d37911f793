// recording/scene.cpp: see recording/scene.hpp.
#include "recording/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "recording/scene_parts.hpp"
#include "recording/topic_channel.hpp"

namespace teamsight::recording {
namespace {

using parts::add_arrow;
using parts::add_disc;
using parts::add_ellipse;
using parts::add_entity;
using parts::add_fact;
using parts::add_text;
using parts::Paint;

constexpr Paint kCarpet{0.13, 0.37, 0.20, 1.0};
constexpr Paint kWhite{1.0, 1.0, 1.0, 1.0};
constexpr Paint kOurs{0.20, 0.60, 1.0, 1.0};
constexpr Paint kNotBelieved{0.55, 0.55, 0.60, 1.0};
constexpr Paint kTheirs{0.90, 0.25, 0.25, 1.0};
constexpr Paint kBall{1.0, 0.55, 0.0, 1.0};

constexpr double kLifetime = 0.5;       // s
constexpr double kBallDiameter = 0.22;  // m, the league's
constexpr double kRobotWidth = 0.5;     // m
constexpr double kRobotHeight = 0.6;    // m
constexpr double kMinDraw = 0.1;        // m: the least radius an obstacle is drawn with

Paint pale(Paint paint, double opacity) {
  paint.a = opacity;
  return paint;
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

std::string robots_of(RobotMask mask) {
  std::string text;
  for (RobotId robot = 1; robot <= kMaxRobotId; ++robot) {
    if ((mask & robot_bit(robot)) == 0) continue;
    text += (text.empty() ? "" : " ") + std::to_string(static_cast<unsigned>(robot));
  }
  return text;
}

std::string frame_of(RobotId robot) {
  return "robot_" + std::to_string(static_cast<unsigned>(robot));
}

// ---- the field

using Lines = foxglove::LinePrimitive;

Lines& add_lines(foxglove::SceneEntity& entity, Lines::Type type, double width) {
  Lines& lines = *entity.add_lines();
  lines.set_type(type);
  parts::set({0.0, 0.0, 0.0}, 0.0, *lines.mutable_pose());
  lines.set_thickness(width);
  parts::set(kWhite, *lines.mutable_color());
  return lines;
}

void add_point(Lines& lines, double x, double y, double z = 0.005) {
  foxglove::Point3& point = *lines.add_points();
  point.set_x(x);
  point.set_y(y);
  point.set_z(z);
}

void add_arc(foxglove::SceneEntity& entity, const FieldArc& arc, double width) {
  constexpr int kPerTurn = 64;
  const int steps =
      std::max(2, static_cast<int>(std::ceil(arc.sweep / (2 * std::numbers::pi) * kPerTurn)));
  Lines& lines = add_lines(entity, Lines::LINE_STRIP, width);
  for (int i = 0; i <= steps; ++i) {
    const double angle = arc.start + arc.sweep * i / steps;
    add_point(lines,
              arc.centre.x + arc.radius * std::cos(angle),
              arc.centre.y + arc.radius * std::sin(angle));
  }
}

/// The frame of a goal's mouth: posts and bar.
void add_goal(foxglove::SceneEntity& entity, const Goal& goal) {
  Lines& frame = add_lines(entity, Lines::LINE_STRIP, 0.12);
  add_point(frame, goal.left_post.x, goal.left_post.y, 0.0);
  add_point(frame, goal.left_post.x, goal.left_post.y, goal.height);
  add_point(frame, goal.right_post.x, goal.right_post.y, goal.height);
  add_point(frame, goal.right_post.x, goal.right_post.y, 0.0);
  if (goal.colour == GoalColour::kBlue) parts::set(kOurs, *frame.mutable_color());
  if (goal.colour == GoalColour::kYellow) parts::set({1.0, 0.9, 0.0}, *frame.mutable_color());
}

void add_carpet(foxglove::SceneEntity& entity, const FieldModel& field) {
  constexpr double kThick = 0.02;
  foxglove::CubePrimitive& carpet = *entity.add_cubes();
  parts::set({field.centre.x, field.centre.y, -kThick / 2}, 0.0, *carpet.mutable_pose());
  parts::set({field.length + 2 * field.surround, field.width + 2 * field.surround, kThick},
             *carpet.mutable_size());
  parts::set(kCarpet, *carpet.mutable_color());
}

// ---- the world

bool is_believed(const WorldTeammate& mate) {
  return mate.status == PostureStatus::kOk && mate.quarantine == Quarantine::kNone;
}

void add_robot(foxglove::SceneUpdate& scene, const WorldTeammate& mate, std::int64_t log_ns) {
  const Paint paint = is_believed(mate) ? kOurs : kNotBelieved;
  foxglove::SceneEntity& entity = add_entity(scene, frame_of(mate.robot), log_ns, kLifetime);
  const Eigen::Vector3d foot{mate.X_FR.x(), mate.X_FR.y(), 0.0};
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  add_disc(entity,
           foot + up * kRobotHeight / 2,
           {kRobotWidth, kRobotWidth, kRobotHeight},
           pale(paint, 0.85));
  const Eigen::Vector3d ahead{std::cos(mate.X_FR.theta()), std::sin(mate.X_FR.theta()), 0.0};
  add_arrow(entity, foot + up * kRobotHeight, ahead * 0.6, kWhite);
  add_ellipse(entity, foot.head<2>(), mate.cov.topLeftCorner<2, 2>(), pale(paint, 0.35));
  add_text(entity,
           foot + up * (kRobotHeight + 0.4),
           std::to_string(static_cast<unsigned>(mate.robot)),
           kWhite);
  add_fact(entity, "trust", number(mate.trust));
  add_fact(entity, "quarantine", std::to_string(static_cast<unsigned>(mate.quarantine)));
  add_fact(entity, "sees_ball", mate.sees_ball ? "yes" : "no");
}

void add_ball(foxglove::SceneUpdate& scene, const WorldBall& ball, std::int64_t log_ns) {
  foxglove::SceneEntity& entity =
      add_entity(scene, "ball_" + std::to_string(ball.track), log_ns, kLifetime);
  const Eigen::Vector3d centre = ball.p_FB.vector();
  foxglove::SpherePrimitive& sphere = *entity.add_spheres();
  parts::set(centre, 0.0, *sphere.mutable_pose());
  parts::set({kBallDiameter, kBallDiameter, kBallDiameter}, *sphere.mutable_size());
  parts::set(pale(kBall, 0.3 + 0.7 * ball.existence), *sphere.mutable_color());
  add_arrow(entity, centre, ball.v_FB.vector(), kBall);
  add_ellipse(entity, centre.head<2>(), ball.cov_p.topLeftCorner<2, 2>(), pale(kBall, 0.35));
  add_fact(entity, "existence", number(ball.existence));
  add_fact(entity, "supporters", robots_of(ball.supporters));
  add_fact(entity, "rejected", robots_of(ball.rejected));
}

void add_obstacle(foxglove::SceneUpdate& scene, const WorldObstacle& thing, std::int64_t log_ns) {
  foxglove::SceneEntity& entity =
      add_entity(scene, "obstacle_" + std::to_string(thing.track), log_ns, kLifetime);
  const Eigen::Vector3d foot{thing.p_FO.x, thing.p_FO.y, 0.0};
  const double width = 2 * std::max(thing.radius, kMinDraw);
  add_disc(entity,
           foot + Eigen::Vector3d::UnitZ() * kRobotHeight / 2,
           {width, width, kRobotHeight},
           pale(kTheirs, 0.25 + 0.6 * thing.existence));
  add_arrow(entity,
            foot + Eigen::Vector3d::UnitZ() * kRobotHeight,
            {thing.v_FO.x, thing.v_FO.y, 0.0},
            kTheirs);
  add_ellipse(entity, foot.head<2>(), thing.cov_p, pale(kTheirs, 0.35));
  add_text(entity,
           foot + Eigen::Vector3d::UnitZ() * (kRobotHeight + 0.3),
           std::to_string(thing.track),
           kTheirs);
  add_fact(entity, "existence", number(thing.existence));
  add_fact(entity, "supporters", robots_of(thing.supporters));
}

template <class Message>
Channel channel_named(const char* topic) {
  return {topic, "protobuf", schema_of(*Message::descriptor())};
}

}  // namespace

std::string field_scene(const FieldModel& field, std::int64_t log_ns) {
  foxglove::SceneUpdate scene;
  foxglove::SceneEntity& entity = add_entity(scene, "field", log_ns, 0.0);
  add_carpet(entity, field);
  if (!field.lines.empty()) {
    Lines& lines = add_lines(entity, Lines::LINE_LIST, field.line_width);
    for (const FieldLine& line : field.lines) {
      add_point(lines, line.from.x, line.from.y);
      add_point(lines, line.to.x, line.to.y);
    }
  }
  for (const FieldArc& arc : field.arcs) add_arc(entity, arc, field.line_width);
  for (const FieldSpot& spot : field.spots) {
    add_disc(entity,
             {spot.centre.x, spot.centre.y, 0.005},
             {2 * spot.radius, 2 * spot.radius, 0.01},
             kWhite);
  }
  for (const Goal& goal : field.goals) add_goal(entity, goal);
  return scene.SerializeAsString();
}

std::string ball_scene(const WorldModel& world, std::int64_t log_ns) {
  foxglove::SceneUpdate scene;
  for (const WorldBall& ball : world.balls) add_ball(scene, ball, log_ns);
  return scene.SerializeAsString();
}

std::string robot_scene(const WorldModel& world, std::int64_t log_ns) {
  foxglove::SceneUpdate scene;
  for (const WorldTeammate& mate : world.teammates) {
    if (mate.status != PostureStatus::kLost) add_robot(scene, mate, log_ns);
  }
  return scene.SerializeAsString();
}

std::string obstacle_scene(const WorldModel& world, std::int64_t log_ns) {
  foxglove::SceneUpdate scene;
  for (const WorldObstacle& obstacle : world.obstacles) add_obstacle(scene, obstacle, log_ns);
  return scene.SerializeAsString();
}

std::string robot_frames(const WorldModel& world, std::int64_t log_ns) {
  foxglove::FrameTransforms frames;
  for (const WorldTeammate& mate : world.teammates) {
    if (mate.status == PostureStatus::kLost) continue;
    foxglove::FrameTransform& frame = *frames.add_transforms();
    parts::set(log_ns, *frame.mutable_timestamp());
    frame.set_parent_frame_id(parts::kFieldFrame);
    frame.set_child_frame_id(frame_of(mate.robot));
    parts::set({mate.X_FR.x(), mate.X_FR.y(), 0.0}, *frame.mutable_translation());
    parts::set_yaw(mate.X_FR.theta(), *frame.mutable_rotation());
  }
  return frames.SerializeAsString();
}

std::string log_entry(LogLevel level,
                      const std::string& name,
                      const std::string& text,
                      std::int64_t log_ns) {
  foxglove::Log entry;
  parts::set(log_ns, *entry.mutable_timestamp());
  entry.set_level(static_cast<foxglove::Log::Level>(level));
  entry.set_name(name);
  entry.set_message(text);
  return entry.SerializeAsString();
}

Channel log_channel() {
  return channel_named<foxglove::Log>("log");
}

SceneChannels::SceneChannels(MessageSink& sink)
    : sink_(&sink),
      field_(sink.add_channel(channel_named<foxglove::SceneUpdate>("scene/field"))),
      of_world_{
          {{sink.add_channel(channel_named<foxglove::SceneUpdate>("scene/ball")), ball_scene},
           {sink.add_channel(channel_named<foxglove::SceneUpdate>("scene/robots")), robot_scene},
           {sink.add_channel(channel_named<foxglove::SceneUpdate>("scene/obstacles")),
            obstacle_scene},
           {sink.add_channel(channel_named<foxglove::FrameTransforms>("scene/frames")),
            robot_frames}}} {}

std::int64_t SceneChannels::log_ns(HostTime time) const {
  return (time.time_since_epoch() + sink_->log_minus_host()).count();
}

void SceneChannels::write(const FieldModel& field, HostTime now) {
  if (!sink_->is_wanted(field_)) return;
  sink_->write(field_, now, stamp_of(now), field_scene(field, log_ns(now)));
}

void SceneChannels::write(const WorldModel& world, HostTime received) {
  for (const WorldChannel& channel : of_world_) {
    if (!sink_->is_wanted(channel.id)) continue;
    sink_->write(channel.id, received, world.stamp, channel.make(world, log_ns(received)));
  }
}

}  // namespace teamsight::recording
