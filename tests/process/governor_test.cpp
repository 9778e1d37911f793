// tests/process/governor_test.cpp: what is left out when the air is full, and when it comes back.
#include "process/governor.hpp"

#include <gtest/gtest.h>

#include "process/air_share.hpp"
#include "process/token_bucket.hpp"

namespace teamsight::process {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr HostTime kStart{seconds(100)};

/// Everybody says `bps` and the governor steps, once a second.
Thrift live(Governor& governor, double bps, int from_s, int to_s) {
  for (int second = from_s; second < to_s; ++second) {
    const HostTime now = kStart + seconds(second);
    governor.heard("agent/1", bps / 2, now);
    governor.heard("agent/2", bps / 2, now);
    governor.step(now);
  }
  return governor.thrift();
}

TEST(Governor, LeavesATeamWithinItsBudgetAlone) {
  Governor governor({});

  EXPECT_EQ(live(governor, 2.0e6, 0, 60), Thrift::kNone);
  EXPECT_DOUBLE_EQ(governor.team_bps(kStart + seconds(59)), 2.0e6);
}

TEST(Governor, TakesOneStepASecondWhileTheBudgetIsBroken) {
  Governor governor({});
  live(governor, 1.5e6, 0, 4);

  EXPECT_EQ(live(governor, 2.3e6, 4, 5), Thrift::kRareDiagnostics);
  EXPECT_EQ(live(governor, 2.3e6, 5, 7), Thrift::kSlowWorld);
  EXPECT_EQ(live(governor, 2.3e6, 7, 14), Thrift::kNoObstacles);
}

TEST(Governor, IsNotFrightenedByTheBurstOfAStart) {
  Governor governor({});

  EXPECT_EQ(live(governor, 6.0e6, 0, 3), Thrift::kNone);
  EXPECT_EQ(live(governor, 1.5e6, 3, 10), Thrift::kNone);
}

TEST(Governor, LooksAheadWhenTheRateRises) {
  Governor governor({});
  live(governor, 1.6e6, 0, 5);

  EXPECT_EQ(live(governor, 1.9e6, 5, 6), Thrift::kRareDiagnostics);
}

TEST(Governor, GivesBackOneStepAfterEachWhileOfCalm) {
  Governor governor({});
  live(governor, 1.5e6, 0, 4);
  live(governor, 2.3e6, 4, 6);

  EXPECT_EQ(live(governor, 1.5e6, 6, 10), Thrift::kNearObstacles);
  EXPECT_EQ(live(governor, 1.5e6, 10, 12), Thrift::kRareDiagnostics);
  EXPECT_EQ(live(governor, 1.5e6, 12, 17), Thrift::kNone);
}

TEST(Governor, NeitherTakesNorGivesBetweenTheTwoMarks) {
  Governor governor({});
  live(governor, 1.5e6, 0, 4);
  live(governor, 2.3e6, 4, 6);

  EXPECT_EQ(live(governor, 1.9e6, 6, 60), Thrift::kNearObstacles);
}

TEST(Governor, ForgetsWhoSaysNothing) {
  Governor governor({});
  governor.heard("agent/1", 1e6, kStart);

  EXPECT_EQ(governor.team_bps(kStart + seconds(6)), 0.0);
}

TEST(Governor, IsNotFilledByForgedNames) {
  Governor governor({});
  for (int i = 0; i < 1000; ++i) governor.heard("agent/" + std::to_string(i), 1.0, kStart);

  EXPECT_EQ(governor.team_bps(kStart), 64.0);
}

bus::Sightings sightings_near_and_far() {
  bus::Sightings sightings;
  BallRay ball;  // meets the floor at (2, 0)
  ball.ray_R.origin = {0.0, 0.0, 1.0};
  ball.ray_R.direction = {2.0, 0.0, -1.0};
  sightings.balls = {ball};
  ObstacleSighting near;
  near.p_RO = {5.0, 0.0};
  ObstacleSighting far;
  far.p_RO = {-3.0, 0.0};
  sightings.obstacles = {near, far};
  return sightings;
}

TEST(Trim, KeepsWhatIsNearTheBallFirst) {
  bus::Sightings sightings = sightings_near_and_far();

  EXPECT_EQ(trim(sightings, Thrift::kRareDiagnostics), 0U);
  EXPECT_EQ(trim(sightings, Thrift::kNearObstacles), 1U);
  ASSERT_EQ(sightings.obstacles.size(), 1U);
  EXPECT_EQ(sightings.obstacles[0].p_RO.x, 5.0);
}

TEST(Trim, NeverTouchesBallAndPosture) {
  bus::Sightings sightings = sightings_near_and_far();
  const bus::Sightings before = sightings;

  EXPECT_EQ(trim(sightings, kMostThrift), 2U);
  EXPECT_EQ(sightings.balls, before.balls);
  EXPECT_EQ(sightings.posture, before.posture);
}

TEST(TokenBucket, LetsTheRateThroughAndABurstAtOnce) {
  TokenBucket bucket(1000.0, 500.0);

  EXPECT_TRUE(bucket.take(500.0, kStart));
  EXPECT_FALSE(bucket.take(100.0, kStart + milliseconds(50)));
  EXPECT_TRUE(bucket.take(100.0, kStart + milliseconds(100)));
  EXPECT_FALSE(bucket.take(501.0, kStart + seconds(60)));
}

}  // namespace
}  // namespace teamsight::process
