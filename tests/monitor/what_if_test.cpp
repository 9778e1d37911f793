// tests/monitor/what_if_test.cpp: the world without one robot, from samples and times alone.
#include "monitor/what_if.hpp"

#include <chrono>
#include <optional>

#include <gmock/gmock.h>

#include "settings/load.hpp"
#include "tests/monitor/fake_team.hpp"
#include "tests/support/process.hpp"

namespace teamsight::monitor {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const HostTime kStart{seconds(1000)};
constexpr Duration kLeaderAhead = seconds(50'000);  // of the station's clock
constexpr Duration kRobotsAhead = seconds(20'000);  // of the leader's clock
constexpr int kFrames = 50;                         // 2 s at 25 Hz

template <class Message>
bus::Sample<Message> sample_of(const Message& message, HostTime received) {
  bus::Sample<Message> sample;
  sample.message = message;
  sample.received = received;
  return sample;
}

/// The station's time of frame `k`.
HostTime frame_time(int k) {
  return kStart + k * milliseconds(40);
}

WhatIf what_if() {
  return {fusion::Parameters{},
          settings::load_field(test::source_path("config/fields/msl-2024.textproto"))};
}

/// What the leader tells of the robots' clocks.
void tell_clocks(WhatIf& what_if) {
  bus::Explanation explanation;
  for (RobotId robot = 1; robot <= test::kFakeRobots; ++robot) {
    bus::ExplainedRobot& one = explanation.robots.emplace_back();
    one.robot = robot;
    one.clock_offset = kRobotsAhead;
    one.clock_sigma = milliseconds(1);
  }
  what_if.hear(sample_of(explanation, kStart));
}

/// Two seconds of the fake team, each robot and the leader with clocks of their own.
void play(WhatIf& what_if) {
  for (int k = 1; k <= kFrames; ++k) {
    const auto count = static_cast<std::uint32_t>(k);
    const HostTime now = frame_time(k);
    const HostTime leaders = now + kLeaderAhead;
    what_if.hear(sample_of(test::fake_world({3, 1, count}, leaders), now));
    for (RobotId robot = 1; robot <= test::kFakeRobots; ++robot) {
      bus::Sightings seen = test::fake_sightings({robot, 1, count}, leaders - milliseconds(30));
      seen.exposure += kRobotsAhead;
      seen.published += kRobotsAhead;
      what_if.hear(sample_of(seen, now));
    }
  }
}

TEST(WhatIf, LeavesOneRobotOutAndKeepsTheOthers) {
  WhatIf what = what_if();
  tell_clocks(what);
  what.ask(2, frame_time(kFrames) + seconds(1));

  play(what);
  const auto without = what.at(frame_time(kFrames));

  ASSERT_TRUE(without.has_value());
  EXPECT_EQ(without->robot, 2);
  ASSERT_FALSE(without->world.balls.empty());
  const WorldBall& ball = without->world.balls.front();
  EXPECT_EQ(ball.supporters & robot_bit(2), 0);
  EXPECT_NE(ball.supporters & robot_bit(3), 0);
  const WorldBall told = test::fake_world({}, frame_time(kFrames) + kLeaderAhead).balls.front();
  EXPECT_LT((ball.p_FB.vector() - told.p_FB.vector()).head<2>().norm(), 0.5);
  EXPECT_EQ(ball.track, told.track) << "called as the leader calls it";
}

TEST(WhatIf, IsSilentWhileNobodyAsksAndWithoutALeader) {
  WhatIf unasked = what_if();
  WhatIf leaderless = what_if();
  leaderless.ask(2, kStart + seconds(9));

  play(unasked);

  EXPECT_FALSE(unasked.at(frame_time(kFrames)).has_value());
  EXPECT_FALSE(leaderless.at(kStart).has_value());
}

TEST(WhatIf, EndsWithTheTimeItWasAskedFor) {
  WhatIf what = what_if();
  what.ask(2, frame_time(kFrames) + milliseconds(1));
  play(what);

  EXPECT_TRUE(what.at(frame_time(kFrames)).has_value());
  EXPECT_FALSE(what.at(frame_time(kFrames) + milliseconds(1)).has_value());
}

TEST(WhatIf, BelievesNoStampOfAClockThatNobodyKnows) {
  WhatIf what = what_if();
  what.ask(2, frame_time(kFrames) + seconds(1));

  play(what);  // the robots' clocks are hours from the leader's, and no Explanation came

  EXPECT_TRUE(what.at(frame_time(kFrames))->world.teammates.empty());
}

}  // namespace
}  // namespace teamsight::monitor
