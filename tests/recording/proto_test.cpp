// tests/recording/proto_test.cpp: every topic's value survives its recording, and only good ones
// do.
#include <chrono>
#include <limits>

#include <gmock/gmock.h>

#include "recording/from_proto.hpp"
#include "recording/proto_of.hpp"
#include "recording/to_proto.hpp"
#include "recording/topic_channel.hpp"
#include "tests/bus/samples.hpp"

namespace teamsight::recording {
namespace {

template <class Message>
class EveryTopic : public ::testing::Test {};

using Messages = ::testing::Types<bus::RobotState,
                                  bus::Sightings,
                                  bus::VirtualSensors,
                                  bus::Odometry,
                                  WorldModel,
                                  bus::Explanation,
                                  bus::ClockProbe,
                                  bus::ClockEcho,
                                  bus::GameState,
                                  bus::Command,
                                  bus::Diagnostics,
                                  bus::LinePoints,
                                  bus::Thumbnail,
                                  bus::Truth>;
TYPED_TEST_SUITE(EveryTopic, Messages);

TYPED_TEST(EveryTopic, ComesBackFromItsPayloadAsItWas) {
  const auto message = bus::testing::full<TypeParam>();

  const auto back = from_payload<TypeParam>(payload_of(message));

  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(*back, message);
}

TYPED_TEST(EveryTopic, IsNamedByTopicAndType) {
  const Channel channel = channel_of<TypeParam>();

  EXPECT_THAT(channel.topic, ::testing::StartsWith("teamsight/v1/"));
  EXPECT_THAT(channel.schema.name, ::testing::StartsWith("teamsight.v1."));
  EXPECT_EQ(channel.encoding, "protobuf");
}

TYPED_TEST(EveryTopic, IsNotMadeFromOtherBytes) {
  EXPECT_FALSE(from_payload<TypeParam>("\xff\xff\xff garbage").has_value());
  EXPECT_FALSE(from_payload<TypeParam>("").has_value()) << "an empty message has no identity";
}

TEST(FromPayload, RefusesWhatAReaderOnTheBusWouldHaveDropped) {
  v1::RobotState proto;
  to_proto(bus::testing::full<bus::RobotState>(), proto);

  v1::RobotState not_finite = proto;
  not_finite.set_vx_mps(std::numeric_limits<double>::quiet_NaN());
  v1::RobotState short_cov = proto;
  short_cov.mutable_posture()->mutable_posture()->mutable_cov()->RemoveLast();
  v1::RobotState wrong_robot = proto;
  wrong_robot.mutable_sample()->set_robot_id(259);  // 3 when cut to a byte
  v1::RobotState wrong_status = proto;
  wrong_status.mutable_posture()->set_status(static_cast<v1::PostureStatus>(7));

  EXPECT_TRUE(from_payload<bus::RobotState>(proto.SerializeAsString()));
  EXPECT_FALSE(from_payload<bus::RobotState>(not_finite.SerializeAsString()));
  EXPECT_FALSE(from_payload<bus::RobotState>(short_cov.SerializeAsString()));
  EXPECT_FALSE(from_payload<bus::RobotState>(wrong_robot.SerializeAsString()));
  EXPECT_FALSE(from_payload<bus::RobotState>(wrong_status.SerializeAsString()));
}

}  // namespace
}  // namespace teamsight::recording
