// tests/fusion/ball_choice_test.cpp: which ball of now is the ball of before, and which one comes
// first.
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "fusion/fusion.hpp"
#include "tests/fusion/scenario.hpp"
#include "tests/fusion/watch.hpp"

namespace teamsight::fusion {
namespace {

using std::chrono::seconds;
using test::at_second;
using test::Eye;
using test::kBall;
using test::kLeftOfBall;
using test::kRightOfBall;
using test::make_fusion;
using test::see_the_ball;
using test::watch;

TEST(BallChoice, ListsNoPlaceThatIsTooUncertainButFindsItAgainUnderItsId) {
  Parameters parameters;
  parameters.ball.max_sigma_published = 0.5;
  parameters.ball.death_age = seconds(60);
  Fusion fusion(parameters, test::plain_field());
  Eye eye(1, 11);
  watch(fusion, eye, kLeftOfBall, {0.0, 1.0}, see_the_ball);
  const std::uint32_t track = fusion.world_at(at_second(1.0)).balls.at(0).track;

  const WorldModel unseen = fusion.world_at(at_second(3.0));
  watch(fusion, eye, kLeftOfBall, {3.0, 3.1}, see_the_ball);
  const WorldModel seen_again = fusion.world_at(at_second(3.1));

  EXPECT_TRUE(unseen.balls.empty());
  ASSERT_EQ(seen_again.balls.size(), 1U);
  EXPECT_EQ(seen_again.balls[0].track, track);
}

TEST(BallChoice, FindsALostBallAgainUnderItsIdWhereverItIs) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  watch(fusion, eye, kLeftOfBall, {0.0, 1.0}, see_the_ball);
  const std::uint32_t track = fusion.world_at(at_second(1.0)).balls.at(0).track;

  watch(fusion, eye, kLeftOfBall, {1.0, 8.0}, [](Eye&) {});
  const WorldModel lost = fusion.world_at(at_second(8.0));
  watch(fusion, eye, kLeftOfBall, {8.0, 8.3}, [](Eye& e) { e.see_ball({-1.0, -1.5}); });
  const WorldModel found = fusion.world_at(at_second(8.3));

  EXPECT_TRUE(lost.balls.empty());
  ASSERT_EQ(found.balls.size(), 1U);
  EXPECT_EQ(found.balls[0].track, track);
}

TEST(BallChoice, ABallThatMayBeAnywhereIsTheOneThatIsFoundWithinItsReach) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  watch(fusion, eye, kLeftOfBall, {0.0, 1.0}, see_the_ball);
  const std::uint32_t track = fusion.world_at(at_second(1.0)).balls.at(0).track;

  watch(fusion, eye, kLeftOfBall, {3.0, 3.3}, [](Eye& e) { e.see_ball({0.0, -0.5}); });
  const WorldModel found = fusion.world_at(at_second(3.3));

  ASSERT_EQ(found.balls.size(), 1U);
  EXPECT_EQ(found.balls[0].track, track);
  EXPECT_NEAR(found.balls[0].p_FB.x, 0.0, 0.1);
}

TEST(BallChoice, ABallSeenBesideAKnownOneIsAnother) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  watch(fusion, eye, kLeftOfBall, {0.0, 1.0}, see_the_ball);
  const std::uint32_t track = fusion.world_at(at_second(1.0)).balls.at(0).track;

  watch(fusion, eye, kLeftOfBall, {1.0, 1.5}, [](Eye& e) {
    e.see_ball(kBall);
    e.see_ball({-1.0, -1.5});
  });
  const WorldModel both = fusion.world_at(at_second(1.5));

  ASSERT_EQ(both.balls.size(), 2U);
  EXPECT_NE(both.balls[0].track, both.balls[1].track);
  EXPECT_TRUE(both.balls[0].track == track || both.balls[1].track == track);
}

TEST(BallChoice, TwoBallsThatPassEachOtherStayTwo) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  double t = 0.0;
  // One rolls past the other, which lies at kBall, at 5 cm.
  const auto see_both = [&t](Eye& e) {
    e.see_ball(kBall);
    e.see_ball({kBall.x + 4.0 * (t - 0.5), kBall.y + 0.05});
    t += 0.033;
  };
  watch(fusion, eye, kLeftOfBall, {0.0, 0.429}, see_both);
  const std::vector<WorldBall> before = fusion.world_at(at_second(0.42)).balls;
  watch(fusion, eye, kLeftOfBall, {0.429, 0.561}, see_both);
  const std::vector<WorldBall> after = fusion.world_at(at_second(0.55)).balls;

  ASSERT_EQ(before.size(), 2U);
  ASSERT_EQ(after.size(), 2U);
  for (const WorldBall& ball : after) {
    const bool was_first = ball.track == before[0].track;
    EXPECT_TRUE(was_first || ball.track == before[1].track);
    const WorldBall& same = was_first ? before[0] : before[1];
    EXPECT_NEAR(ball.v_FB.x, same.v_FB.x, 1.0);
  }
}

TEST(BallChoice, ABallThatIsHiddenForAMomentDoesNotGiveWayToWhatOneRobotBeginsToSee) {
  Fusion fusion{Parameters{}, test::plain_field()};
  Eye left(1, 11);
  Eye right(4, 44);
  watch(fusion, left, kLeftOfBall, {0.0, 2.0}, see_the_ball);
  ASSERT_FALSE(fusion.world_at(at_second(2.0)).balls.empty());
  const std::uint32_t ball = fusion.world_at(at_second(2.0)).balls[0].track;

  const Pose<Field, Robot> far_away(9.0, -5.0, 2.0);
  watch(fusion, right, far_away, {2.0, 2.4}, [](Eye& eye) { eye.see_ball({7.0, -4.0}); });

  const WorldModel world = fusion.world_at(at_second(2.4));
  ASSERT_EQ(world.balls.size(), 2U);
  EXPECT_EQ(world.balls[0].track, ball);
}

TEST(BallChoice, WhatTwoRobotsSeeComesBeforeWhatOneHasSeenAllAlong) {
  Fusion fusion = make_fusion();
  Eye alone(1, 11);
  Eye left(2, 22);
  Eye right(3, 33);
  const Pose<Field, Robot> far_away(9.0, -5.0, 2.0);
  const auto see_another = [](Eye& eye) {
    eye.see_ball({7.0, -4.0});
  };
  watch(fusion, alone, far_away, {0.0, 1.0}, see_another);
  const std::uint32_t first = fusion.world_at(at_second(1.0)).balls.at(0).track;

  for (int i = 0; i < 10; ++i) {
    const double t = 1.0 + 0.1 * i;
    watch(fusion, alone, far_away, {t, t + 0.1}, see_another);
    watch(fusion, left, kLeftOfBall, {t, t + 0.1}, see_the_ball);
    watch(fusion, right, kRightOfBall, {t, t + 0.1}, see_the_ball);
  }

  const WorldModel world = fusion.world_at(at_second(2.0));
  ASSERT_EQ(world.balls.size(), 2U);
  EXPECT_NE(world.balls[0].track, first);
  EXPECT_EQ(world.balls[1].track, first);
}

TEST(BallChoice, WhatOneRobotSeesWhereNoKickCanHaveLedComesSecond) {
  Fusion fusion = make_fusion();
  Eye left(1, 11);
  Eye right(4, 44);
  // At its foot: a kick that nobody has seen may have led the ball anywhere near.
  watch(fusion, left, {0.6, 0.5, 0.0}, {0.0, 2.0}, see_the_ball);
  const std::uint32_t ball = fusion.world_at(at_second(2.0)).balls.at(0).track;

  const Pose<Field, Robot> far_away(9.0, -5.0, 2.0);
  watch(fusion, right, far_away, {2.0, 2.3}, [](Eye& eye) { eye.see_ball({7.0, -4.0}); });

  const WorldModel world = fusion.world_at(at_second(2.3));
  ASSERT_EQ(world.balls.size(), 2U);
  EXPECT_GT(world.balls[0].cov_p(0, 0), 0.25);
  EXPECT_EQ(world.balls[0].track, ball);
}

/// Two robots lose the ball out of sight though they look where it was; a third one, far away,
/// insists on something that nobody else can see.
WorldModel after_a_false_alarm(const Parameters& parameters) {
  Fusion fusion(parameters, test::plain_field());
  Eye left(1, 11);
  Eye right(2, 22);
  Eye far(4, 44);
  const auto nothing = [](Eye&) {
  };
  const Pose<Field, Robot> far_away(9.0, -5.0, 2.0);
  constexpr double kTurn = 0.1;  // s
  for (int turn = 0; turn < 20; ++turn) {
    const double t = kTurn * turn;
    watch(fusion, left, kLeftOfBall, {t, t + kTurn}, see_the_ball);
    watch(fusion, right, kRightOfBall, {t, t + kTurn}, see_the_ball);
  }
  for (int turn = 20; turn < 30; ++turn) {
    const double t = kTurn * turn;
    watch(fusion, left, kLeftOfBall, {t, t + kTurn}, nothing);
    watch(fusion, right, kRightOfBall, {t, t + kTurn}, nothing);
    if (turn < 27) continue;
    watch(fusion, far, far_away, {t, t + kTurn}, [](Eye& eye) { eye.see_ball({7.0, -4.0}); });
  }
  return fusion.world_at(at_second(3.0));
}

TEST(BallChoice, ABallThatTheTeamHasSeenDoesNotCeaseToBeByMisses) {
  Parameters gives_up;
  gives_up.ball.lasting_log_odds = std::numeric_limits<double>::infinity();

  const WorldModel given_up = after_a_false_alarm(gives_up);
  const WorldModel world = after_a_false_alarm(Parameters{});

  ASSERT_EQ(given_up.balls.size(), 1U);
  EXPECT_NEAR(given_up.balls[0].p_FB.x, 7.0, 0.2);
  for (const WorldBall& ball : world.balls) EXPECT_LT(ball.p_FB.x, 5.0);
}

}  // namespace
}  // namespace teamsight::fusion
