// tests/monitor/order_test.cpp: what a page may ask for, and how an order reaches its robots.
#include "monitor/order.hpp"

#include <chrono>
#include <limits>
#include <string>
#include <variant>

#include <gmock/gmock.h>

#include "monitor.pb.h"
#include "monitor/order_desk.hpp"
#include "monitor/secret.hpp"

namespace teamsight::monitor {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kToken = "0123456789abcdef";
const HostTime kNow{seconds(100)};

v1::MonitorRequest relocate(std::uint32_t robot, double x_m) {
  v1::MonitorRequest request;
  request.set_token(kToken);
  request.mutable_relocate()->set_robot_id(robot);
  request.mutable_relocate()->set_x_m(x_m);
  request.mutable_relocate()->set_theta_rad(1.5);
  return request;
}

std::string refusal(const v1::MonitorRequest& request) {
  const auto order = parse_order(request.SerializeAsString(), kToken);
  return order ? std::string() : order.error();
}

RobotOrder mute(RobotId robot) {
  RobotOrder order;
  order.command.kind = bus::CommandKind::kMute;
  order.command.target = robot;
  order.text = "mute";
  return order;
}

TEST(Order, IsTakenFromAPageThatKnowsTheToken) {
  const auto order = parse_order(relocate(3, 2.5).SerializeAsString(), kToken);

  ASSERT_TRUE(order.has_value());
  const auto& robot = std::get<RobotOrder>(*order);
  EXPECT_EQ(robot.command.kind, bus::CommandKind::kRelocate);
  EXPECT_EQ(robot.command.target, 3);
  EXPECT_EQ(robot.command.X_FR.x(), 2.5);
  EXPECT_EQ(robot.text, "relocate robot 3");
}

TEST(Order, AsksForALookAtTheWorldWithoutARobot) {
  v1::MonitorRequest request;
  request.set_token(kToken);
  request.mutable_without()->set_robot_id(4);
  request.mutable_without()->set_duration_ms(2500.0);

  const auto order = parse_order(request.SerializeAsString(), kToken);
  request.mutable_without()->set_robot_id(0);

  ASSERT_TRUE(order.has_value());
  EXPECT_EQ(std::get<WithoutOrder>(*order), (WithoutOrder{4, milliseconds(2500)}));
  EXPECT_EQ(refusal(request), "there is no such robot");
}

TEST(Order, IsNeverTakenWithoutTheToken) {
  v1::MonitorRequest request = relocate(3, 2.5);
  for (const char* token : {"", "0", "0123456789abcdeF", "0123456789abcdef0"}) {
    request.set_token(token);
    EXPECT_EQ(refusal(request), "wrong token") << token;
  }
  request.set_token("");
  EXPECT_FALSE(parse_order(request.SerializeAsString(), "").has_value()) << "no token, no orders";
}

TEST(Order, IsRefusedWhenTheBusWouldRefuseIt) {
  EXPECT_FALSE(refusal(relocate(0, 1.0)).empty());
  EXPECT_FALSE(refusal(relocate(17, 1.0)).empty());
  EXPECT_FALSE(refusal(relocate(259, 1.0)).empty());
  EXPECT_FALSE(refusal(relocate(3, 1e6)).empty());
  EXPECT_FALSE(refusal(relocate(3, std::numeric_limits<double>::quiet_NaN())).empty());
  v1::MonitorRequest forever;
  forever.set_token(kToken);
  forever.mutable_thumbnail()->set_duration_ms(1e12);
  EXPECT_FALSE(refusal(forever).empty());
  v1::MonitorRequest odd;
  odd.set_token(kToken);
  odd.mutable_referee()->set_command("start; rm");
  EXPECT_FALSE(refusal(odd).empty());
  odd.clear_order();
  EXPECT_FALSE(refusal(odd).empty());
}

TEST(Order, IsNotMadeFromGarbage) {
  EXPECT_FALSE(parse_order("\xff\xff\xff", kToken).has_value());
  EXPECT_FALSE(parse_order(std::string(100'000, 'x'), kToken).has_value());
  EXPECT_FALSE(parse_order("", kToken).has_value());
}

TEST(Secret, IsDrawnAnewAndComparedWhole) {
  EXPECT_EQ(draw_token().size(), 32U);
  EXPECT_NE(draw_token(), draw_token());
  EXPECT_TRUE(is_same_secret("abc", "abc"));
  EXPECT_FALSE(is_same_secret("abc", "abcabc"));
  EXPECT_FALSE(is_same_secret("", "abc"));
}

TEST(OrderDesk, RepeatsAnOrderUntilTheRobotAcknowledgesIt) {
  OrderDesk desk(7);

  const bus::Command command = desk.take(mute(3), {1, 3}, kNow);
  EXPECT_THAT(desk.due(kNow + milliseconds(100)), IsEmpty());
  const auto again = desk.due(kNow + milliseconds(400));
  ASSERT_THAT(again, SizeIs(1));
  EXPECT_EQ(again[0].command, command.command);
  EXPECT_GT(again[0].id.sequence, command.id.sequence) << "or readers take it for a duplicate";
  desk.hear(1, command.command);
  EXPECT_EQ(desk.report(kNow + seconds(1)).at(0).state, ActionState::kWaiting);
  desk.hear(3, command.command);

  EXPECT_THAT(desk.due(kNow + seconds(1)), IsEmpty());
  EXPECT_EQ(desk.report(kNow + seconds(1)).at(0).state, ActionState::kDone);
}

TEST(OrderDesk, TellsWhoLetsAnOrderWaitWhileThereIsTimeToMendIt) {
  OrderDesk desk(7);
  const bus::Command command = desk.take(mute(kNobody), {1, 3}, kNow);
  desk.hear(1, command.command);

  EXPECT_THAT(desk.unanswered_by({1, 3}, kNow + seconds(1)), IsEmpty());
  EXPECT_THAT(desk.unanswered_by({1, 3}, kNow + seconds(2)), ElementsAre(3));
  EXPECT_THAT(desk.unanswered_by({1}, kNow + seconds(2)), IsEmpty()) << "robot 3 is gone";
  EXPECT_THAT(desk.unanswered_by({1, 3}, kNow + seconds(4)), IsEmpty());
}

RobotOrder unmute(RobotId target) {
  RobotOrder order = mute(target);
  order.command.kind = bus::CommandKind::kUnmute;
  return order;
}

TEST(OrderDesk, DoesNotRepeatAnOrderThatANewerOneHasReplaced) {
  OrderDesk desk(7);
  static_cast<void>(desk.take(mute(3), {1, 3}, kNow));
  static_cast<void>(desk.take(mute(1), {1, 3}, kNow));

  const bus::Command newer = desk.take(unmute(3), {1, 3}, kNow + milliseconds(10));

  const auto again = desk.due(kNow + milliseconds(400));
  ASSERT_THAT(again, SizeIs(2));
  EXPECT_EQ(again[0].target, 1);
  EXPECT_EQ(again[1].command, newer.command);
}

TEST(OrderDesk, WaitsForEveryRobotOfAnOrderToAll) {
  OrderDesk desk(7);
  const bus::Command command = desk.take(mute(kNobody), {1, 3}, kNow);

  desk.hear(1, command.command);
  EXPECT_EQ(desk.report(kNow).at(0).state, ActionState::kWaiting);
  desk.hear(3, command.command);

  EXPECT_EQ(desk.report(kNow).at(0).state, ActionState::kDone);
}

RobotOrder hint() {
  RobotOrder order;
  order.command.kind = bus::CommandKind::kBallHint;
  return order;
}

TEST(OrderDesk, RepeatsAnOrderToAllOnlyToThoseWhoHaveNoNewerOne) {
  OrderDesk desk(7);
  const bus::Command all = desk.take(mute(kNobody), {1, 2, 3}, kNow);
  desk.hear(2, all.command);

  const bus::Command one = desk.take(unmute(3), {1, 2, 3}, kNow + milliseconds(10));

  const auto again = desk.due(kNow + milliseconds(400));
  ASSERT_THAT(again, SizeIs(2));
  EXPECT_EQ(again[0].command, all.command);
  EXPECT_EQ(again[0].target, 1) << "robot 3 would be muted again";
  EXPECT_EQ(again[1].command, one.command);
  EXPECT_EQ(again[1].target, 3);
}

TEST(OrderDesk, DoesNotSayOfAnOrderThatWasReplacedThatItWasCarriedOut) {
  OrderDesk desk(7);
  const bus::Command all = desk.take(mute(kNobody), {3}, kNow);

  const bus::Command one = desk.take(unmute(3), {3}, kNow + milliseconds(10));
  desk.hear(3, one.command);

  const auto reports = desk.report(kNow + seconds(1));
  ASSERT_THAT(reports, SizeIs(1));
  EXPECT_EQ(reports[0].command, one.command);
  EXPECT_NE(reports[0].command, all.command);
}

TEST(OrderDesk, HasABallHintAcknowledgedByTheLeadingFusionNotByRobots) {
  OrderDesk desk(7);
  const bus::Command command = desk.take(hint(), {1, 3}, kNow);

  desk.hear(1, command.command);
  desk.hear(3, command.command);
  desk.hear(bus::ExplainedHint{});
  EXPECT_EQ(desk.report(kNow).at(0).state, ActionState::kWaiting);
  desk.hear(bus::ExplainedHint{command.command, 0, seconds(8)});

  EXPECT_EQ(desk.report(kNow).at(0).state, ActionState::kDone);
}

TEST(OrderDesk, RepeatsOnlyTheNewestBallHint) {
  OrderDesk desk(7);
  static_cast<void>(desk.take(hint(), {1}, kNow));
  const bus::Command newest = desk.take(hint(), {1}, kNow);

  const auto again = desk.due(kNow + milliseconds(400));

  ASSERT_THAT(again, SizeIs(1));
  EXPECT_EQ(again[0].command, newest.command);
}

TEST(OrderDesk, SaysThatNobodyAnswersAndForgetsLater) {
  OrderDesk desk(7);
  static_cast<void>(desk.take(mute(3), {}, kNow));

  EXPECT_EQ(desk.report(kNow + seconds(4)).at(0).state, ActionState::kNoAnswer);
  EXPECT_THAT(desk.due(kNow + seconds(4)), IsEmpty());
  EXPECT_THAT(desk.report(kNow + seconds(11)), IsEmpty());
}

}  // namespace
}  // namespace teamsight::monitor
