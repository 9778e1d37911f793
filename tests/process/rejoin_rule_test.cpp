// tests/process/rejoin_rule_test.cpp: when somebody who lives and is not heard is a reason to act.
#include "process/rejoin_rule.hpp"

#include <gtest/gtest.h>

namespace teamsight::process {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const Unheard kOne{{1}, Sign::kLeased};
const Unheard kOther{{2}, Sign::kLeased};
const Unheard kQuiet{{3}, Sign::kBeside};
const Unheard kDoubtful{{4}, Sign::kDoubtful};
const Unheard kDeaf{{5}, Sign::kUnanswered};

HostTime at(Duration since) {
  return HostTime{seconds(1000)} + since;
}

/// Steps twice a second with the same writers unheard; how often the rule acted.
int steps(RejoinRule& rule, const std::vector<Unheard>& unheard, Duration from, Duration to) {
  int acted = 0;
  for (Duration t = from; t < to; t += milliseconds(500))
    acted += rule.step(unheard, {}, at(t)) ? 1 : 0;
  return acted;
}

TEST(RejoinRule, ActsOnAWriterThatStaysUnheard) {
  RejoinRule rule({});

  EXPECT_EQ(steps(rule, {kOne}, seconds(0), seconds(2)), 0);
  EXPECT_TRUE(rule.step({kOne}, {}, at(seconds(2))));
}

TEST(RejoinRule, WaitsLongerWhereLittleIsSaid) {
  RejoinRule rule({});

  EXPECT_EQ(steps(rule, {kQuiet}, seconds(0), seconds(30)), 0);
  EXPECT_TRUE(rule.step({kQuiet}, {}, at(seconds(30))));
}

TEST(RejoinRule, TakesADoubtfulWriterForAReasonOnceUntilItIsHeard) {
  RejoinRule rule({});

  EXPECT_EQ(steps(rule, {kDoubtful}, seconds(0), seconds(30)), 0);
  EXPECT_EQ(steps(rule, {kDoubtful}, seconds(30), seconds(600)), 1);
  EXPECT_EQ(steps(rule, {}, seconds(600), seconds(601)), 0);
  EXPECT_EQ(steps(rule, {kDoubtful}, seconds(601), seconds(640)), 1);
}

TEST(RejoinRule, ActsAtOnceAndOnceAMinuteOnARobotThatDoesNotAnswer) {
  RejoinRule rule({});

  EXPECT_TRUE(rule.step({kDeaf}, {}, at(seconds(0))));
  EXPECT_EQ(steps(rule, {kDeaf}, milliseconds(500), seconds(60)), 0);
  EXPECT_EQ(steps(rule, {}, seconds(60), seconds(70)), 0);
  EXPECT_TRUE(rule.step({kDeaf}, {}, at(seconds(70))));
}

TEST(RejoinRule, DoesNotActWhileEverybodyIsHeardNowAndThen) {
  RejoinRule rule({});

  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(steps(rule, {kOne}, seconds(2 * i), seconds(2 * i) + milliseconds(1500)), 0);
    EXPECT_FALSE(rule.step({}, {}, at(seconds(2 * i) + milliseconds(1500))));
  }
}

TEST(RejoinRule, TakesAWriterForAReasonOnceAMinute) {
  RejoinRule rule({});

  EXPECT_EQ(steps(rule, {kOne}, seconds(0), seconds(60)), 1);
  EXPECT_EQ(steps(rule, {kOne}, seconds(60), seconds(66)), 1);
}

TEST(RejoinRule, PausesBetweenTwoWriters) {
  RejoinRule rule({});
  ASSERT_EQ(steps(rule, {kOne}, seconds(0), milliseconds(2500)), 1);

  EXPECT_EQ(steps(rule, {kOther}, milliseconds(2500), milliseconds(6500)), 0);
  EXPECT_EQ(steps(rule, {kOther}, milliseconds(6500), milliseconds(7500)), 1);
}

TEST(RejoinRule, ForgetsWhatItSawBeforeTheProcessStoodStill) {
  RejoinRule rule({});
  ASSERT_EQ(steps(rule, {kOne}, seconds(0), seconds(2)), 0);

  EXPECT_FALSE(rule.step({kOne}, {}, at(seconds(10))));
  EXPECT_EQ(steps(rule, {kOne}, milliseconds(10'500), seconds(12)), 0);
}

TEST(RejoinRule, FollowsAPeerThatHasJoinedAnewButNotInACircle) {
  RejoinRule rule({});
  ASSERT_EQ(steps(rule, {}, seconds(0), seconds(2)), 0);

  EXPECT_TRUE(rule.step({}, at(seconds(2)), at(seconds(2))));
  for (Duration t = milliseconds(2500); t < seconds(30); t += milliseconds(500)) {
    EXPECT_FALSE(rule.step({}, at(t), at(t)));
  }
}

}  // namespace
}  // namespace teamsight::process
