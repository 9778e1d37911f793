// tests/agent/light_follower_test.cpp: what an operator reads of the light.
#include "agent/light_follower.hpp"

#include <gmock/gmock.h>

namespace teamsight::agent {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using vision::Light;
using vision::LightState;
using vision::LightStatus;

TEST(LightComplaint, IsNoneWhileTheLightIsFollowed) {
  EXPECT_THAT(light_complaint(Light::kGood, {LightStatus::kFollowing, {0.9, 0.7, 0.5}, 0.9}),
              IsEmpty());
  EXPECT_THAT(light_complaint(Light::kGood, {}), IsEmpty());
}

TEST(LightComplaint, SaysThatTheBoundIsReachedAndWhatToDo) {
  const std::string words =
      light_complaint(Light::kGood, {LightStatus::kAtBound, {1.6, 1.0, 0.7}, 0.1});

  EXPECT_THAT(words, HasSubstr("too far from the camera file's"));
  EXPECT_THAT(words, HasSubstr("teamsight calibrate colours --balance"));
  EXPECT_LE(words.size(), 95U);
}

TEST(LightComplaint, WaitsBeforeItDoubtsTheField) {
  const std::string at_once = light_complaint(Light::kGood, {LightStatus::kDisputed, {}, 0.8});
  const std::string later = light_complaint(Light::kGood, {LightStatus::kDisputed, {}, 0.1});

  EXPECT_THAT(at_once, IsEmpty());
  EXPECT_THAT(later, HasSubstr("green and white are not the camera file's"));
  EXPECT_LE(later.size(), 95U);
}

TEST(LightComplaint, NamesALightInWhichNothingCanBeSeen) {
  EXPECT_THAT(light_complaint(Light::kCovered, {}), HasSubstr("the lens is covered"));
  EXPECT_THAT(light_complaint(Light::kUnknown, {LightStatus::kWaiting, {}, 0.0}),
              HasSubstr("no carpet in sight"));
}

TEST(LightFollower, ShowsItsStateInTheReportBeforeAllCounters) {
  process::ProcessMeter meter("agent/1", 1, 1);
  meter.count("frames.read", 100'000);
  const LightFollower follower(vision::FieldColours{{87, 101, 94}, {200, 128, 128}});

  follower.tell(meter);

  const auto report = meter.report(HostTime{std::chrono::seconds(1)});
  ASSERT_EQ(report.counters.size(), 5U);
  EXPECT_EQ(report.counters[0].name, "light.blue_percent");
  EXPECT_EQ(report.counters[0].value, 100U);
  EXPECT_EQ(report.counters[1].name, "light.confidence_percent");
  EXPECT_EQ(report.counters[1].value, 0U);
}

TEST(LightFollower, ShowsNothingThatItDoesNotFollow) {
  process::ProcessMeter meter("agent/1", 1, 1);

  LightFollower(std::nullopt).tell(meter);

  EXPECT_THAT(meter.report(HostTime{std::chrono::seconds(1)}).counters, IsEmpty());
}

}  // namespace
}  // namespace teamsight::agent
