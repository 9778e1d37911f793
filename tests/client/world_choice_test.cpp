// tests/client/world_choice_test.cpp: the leader's model while it is fresh, else the own host's.
#include "client/world_choice.hpp"

#include <gtest/gtest.h>

namespace teamsight {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

constexpr HostTime kNow{seconds(100)};
// The leader's computer was started an hour before this one.
constexpr Duration kAhead = std::chrono::hours(1);

WorldModel model_of(RobotId maker, PeerTime stamp) {
  WorldModel model;
  model.id = {maker, 1000U + maker, 1};
  model.stamp = stamp;
  return model;
}

WorldModel leaders(HostTime time) {
  return model_of(5, PeerTime{time.time_since_epoch() + kAhead});
}

WorldModel own(HostTime time) {
  return model_of(1, stamp_of(time));
}

TEST(WorldChoice, IsNoneBeforeAnythingWasHeard) {
  const World world = WorldChoice({}).freshest(kNow);

  EXPECT_EQ(world.source, Source::kNone);
  EXPECT_TRUE(world.model.balls.empty());
}

TEST(WorldChoice, PrefersAFreshLeader) {
  WorldChoice choice({});
  choice.heard_own_host(own(kNow));
  choice.heard_leader(leaders(kNow), kNow + milliseconds(2));

  const World world = choice.freshest(kNow + milliseconds(102));

  EXPECT_EQ(world.source, Source::kLeader);
  EXPECT_EQ(world.model.id.robot, 5);
  EXPECT_EQ(world.age, milliseconds(100));
}

TEST(WorldChoice, FallsBackToTheOwnHostWhenTheLeaderIsSilent) {
  WorldChoice choice({});
  choice.heard_leader(leaders(kNow), kNow);
  choice.heard_own_host(own(kNow + milliseconds(290)));

  const World world = choice.freshest(kNow + milliseconds(300));

  EXPECT_EQ(world.source, Source::kOwnHost);
  EXPECT_EQ(world.age, milliseconds(10));
}

TEST(WorldChoice, HandsOutNothingOld) {
  WorldChoice choice({});
  choice.heard_leader(leaders(kNow), kNow);
  choice.heard_own_host(own(kNow));

  EXPECT_EQ(choice.freshest(kNow + seconds(2)).source, Source::kNone);
}

TEST(WorldChoice, SeesTheAgeOfAModelThatLayUnread) {
  WorldChoice choice({});
  choice.heard_leader(leaders(kNow), kNow);

  // Stamped one second later, but taken only when it was 200 ms old.
  choice.heard_leader(leaders(kNow + seconds(1)), kNow + milliseconds(1200));

  EXPECT_EQ(choice.freshest(kNow + milliseconds(1200)).age, milliseconds(200));
  EXPECT_EQ(choice.freshest(kNow + milliseconds(1300)).source, Source::kNone);
}

TEST(WorldChoice, BeginsAnewWithAnotherLeadersClock) {
  WorldChoice choice({});
  choice.heard_leader(leaders(kNow), kNow);

  choice.heard_leader(model_of(4, PeerTime{seconds(7)}), kNow + milliseconds(100));

  const World world = choice.freshest(kNow + milliseconds(110));
  EXPECT_EQ(world.model.id.robot, 4);
  EXPECT_EQ(world.age, milliseconds(10));
}

TEST(WorldChoice, FollowsClocksThatDriftApart) {
  WorldChoice choice({});
  // 100 ppm for an hour: 360 ms; this host's clock runs ahead.
  World world;
  for (int second = 0; second <= 3600; ++second) {
    const HostTime stamped = kNow + seconds(second);
    const HostTime taken = stamped + std::chrono::microseconds(100 * second);
    choice.heard_leader(leaders(stamped), taken);
    world = choice.freshest(taken);
    ASSERT_EQ(world.source, Source::kLeader) << "after " << second << " s";
  }

  EXPECT_LT(world.age, milliseconds(15));
}

}  // namespace
}  // namespace teamsight
