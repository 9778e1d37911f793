// tests/monitor/update_to_proto_test.cpp: values reach the page under the right name and unit.
#include "monitor/update_to_proto.hpp"

#include <chrono>

#include <gtest/gtest.h>

#include "geometry/field_model.hpp"
#include "monitor.pb.h"
#include "recording/to_proto.hpp"

namespace teamsight::monitor {
namespace {

using monitor::to_proto;
using recording::to_proto;
using std::chrono::milliseconds;

TEST(ToProto, KeepsARobotStatesIdentityStampsAndPosture) {
  bus::RobotState state;
  state.id = {3, 77, 12};
  state.exposure = PeerTime{Duration{123456789012345}};
  state.posture.status = PostureStatus::kAmbiguous;
  state.posture.X_FR = {1.5, -2.0, 0.25};
  state.posture.cov = Eigen::Vector3d(0.01, 0.04, 0.09).asDiagonal();
  state.posture.cov(0, 2) = state.posture.cov(2, 0) = 0.002;
  v1::RobotState message;

  to_proto(state, message);

  EXPECT_EQ(message.sample().robot_id(), 3U);
  EXPECT_EQ(message.sample().boot_id(), 77U);
  EXPECT_EQ(message.sample().sequence_number(), 12U);
  EXPECT_EQ(message.exposure_ns(), 123456789012345);
  EXPECT_EQ(message.posture().status(), v1::POSTURE_AMBIGUOUS);
  EXPECT_EQ(message.posture().posture().y_m(), -2.0);
  ASSERT_EQ(message.posture().posture().cov_size(), 6);
  EXPECT_EQ(message.posture().posture().cov(2), 0.002);
  EXPECT_EQ(message.posture().posture().cov(3), 0.04);
}

TEST(ToProto, TurnsDurationsIntoMilliseconds) {
  WorldModel world;
  WorldBall ball;
  ball.age = milliseconds(250);
  world.balls.push_back(ball);
  Update update;
  update.world = world;
  update.world_age = milliseconds(12);
  v1::MonitorUpdate message;

  to_proto(update, message);

  EXPECT_EQ(message.world_age_ms(), 12.0);
  EXPECT_EQ(message.world().balls(0).age_ms(), 250.0);
}

TEST(ToProto, SaysThatALatencyIsNotKnown) {
  Update update;
  update.robots.resize(2);
  update.robots[1].link.latency_p50 = milliseconds(8);
  v1::MonitorUpdate message;

  to_proto(update, message);

  EXPECT_EQ(message.robots(0).latency_p50_ms(), -1.0);
  EXPECT_EQ(message.robots(1).latency_p50_ms(), 8.0);
  EXPECT_FALSE(message.robots(0).has_state());
  EXPECT_FALSE(message.has_world());
}

TEST(ToProto, StateAndEventsJoinedEndToEndReadAsOneUpdate) {
  Update update;
  update.silence = "why";
  update.events.push_back({HostTime{milliseconds(3)}, Level::kAlarm, "it happened"});
  v1::MonitorUpdate state;
  v1::MonitorUpdate events;

  to_proto(update, state);
  events_to_proto(update, events);
  v1::MonitorUpdate joined;
  ASSERT_TRUE(joined.ParseFromString(events.SerializeAsString() + state.SerializeAsString() +
                                     events.SerializeAsString()));

  EXPECT_EQ(state.events_size(), 0);
  EXPECT_EQ(joined.silence(), "why");
  ASSERT_EQ(joined.events_size(), 2);
  EXPECT_EQ(joined.events(1).level(), "alarm");
  EXPECT_EQ(joined.events(1).stamp_ns(), 3000000);
}

TEST(ToProto, DrawsTheFieldWithEveryShape) {
  FieldModel field;
  field.length = 22.0;
  field.lines.push_back({"goal line", {-11, -7}, {-11, 7}, LineFamily::kVertical});
  field.arcs.push_back({"centre circle", {0, 0}, 2.0, 0.0, 6.28});
  field.spots.push_back({"centre mark", {0, 0}, 0.06});
  field.goals.push_back({"own", {-11, -1}, {-11, 1}, 1.0, 0.5, GoalColour::kYellow});
  field.walls.push_back({"left", {-11, 8}, {11, 8}, 0.5});
  v1::MonitorField message;

  to_proto(field, message);

  EXPECT_EQ(message.length_m(), 22.0);
  EXPECT_EQ(message.lines(0).to_y_m(), 7.0);
  EXPECT_EQ(message.arcs(0).radius_m(), 2.0);
  EXPECT_EQ(message.spots_size(), 1);
  EXPECT_EQ(message.goals(0).mouth().from_x_m(), -11.0);
  EXPECT_EQ(message.goals(0).colour(), 2U);
  EXPECT_EQ(message.walls(0).from_y_m(), 8.0);
}

}  // namespace
}  // namespace teamsight::monitor
