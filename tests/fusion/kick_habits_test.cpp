// tests/fusion/kick_habits_test.cpp: how often the balls of this game are kicked into the air.
#include "fusion/kick_habits.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "fusion/state.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;
using test::Eye;

const BallMotion kMotion;

KickTally tally_of(int along, int high) {
  KickTally tally;
  for (int i = 0; i < along; ++i) count_kick(tally, BallMode::kRolling, kMotion);
  for (int i = 0; i < high; ++i) count_kick(tally, BallMode::kFlying, kMotion);
  return tally;
}

TEST(KickHabits, BeginWithWhatIsKnownOfAllGames) {
  EXPECT_EQ(high_share(KickTally{}, kMotion), kMotion.high_share);
}

TEST(KickHabits, FollowWhatThisGameShows) {
  EXPECT_LT(high_share(tally_of(10, 0), kMotion), 0.5 * kMotion.high_share);
  EXPECT_GT(high_share(tally_of(2, 8), kMotion), 0.5);
}

TEST(KickHabits, NeverRuleOutAKickIntoTheAirAndForgetWhatWasLongAgo) {
  EXPECT_GT(high_share(tally_of(10000, 0), kMotion), 0.005);
  EXPECT_GT(high_share(tally_of(10000, 100), kMotion), 0.7);
}

/// Where a ball is at t: it lies for a second, then somebody kicks it along the floor.
Point<Field> kicked_ball(double t) {
  const double since = std::max(0.0, t - 1.0);
  return {1.0 + 3.0 * since - 0.5 * kMotion.friction * since * since, 0.5};
}

TEST(KickHabits, AreLearnedFromAKickThatSeveralRobotsSee) {
  const Setting setting{Parameters{}, test::plain_field()};
  State state;
  Eye near_it(1, 11);
  Eye aside(2, 12);
  double before = 0.0;
  for (double t = 0.0; t < 2.0; t += 0.033) {
    if (t < 1.0) before = state.kicks.along + state.kicks.high;
    near_it.look({0.5, 0.5, 0.0}, at_second(t));
    near_it.see_ball(kicked_ball(t));
    advance(state, near_it.frame(), setting);
    aside.look({2.0, -2.0, 1.0}, at_second(t + 0.015));
    aside.see_ball(kicked_ball(t + 0.015));
    advance(state, aside.frame(), setting);
  }

  EXPECT_EQ(before, 0.0) << "of a ball that lies";
  EXPECT_EQ(state.kicks.along, 1.0);
  EXPECT_EQ(state.kicks.high, 0.0);
}

}  // namespace
}  // namespace teamsight::fusion
