// tests/fusion/fusion_test.cpp: what a few robots' observations become.
#include "fusion/fusion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/fusion/scenario.hpp"
#include "tests/fusion/watch.hpp"

namespace teamsight::fusion {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::at_second;
using test::Eye;
using test::kBall;
using test::kLeftOfBall;
using test::kRightOfBall;
using test::make_fusion;
using test::see_the_ball;
using test::watch;

TEST(Fusion, KnowsNothingBeforeTheFirstObservation) {
  const WorldModel world = make_fusion().world_at(at_second(0.0));

  EXPECT_TRUE(world.balls.empty());
  EXPECT_TRUE(world.teammates.empty());
  EXPECT_TRUE(world.obstacles.empty());
}

TEST(Fusion, ShowsABallThatTwoRobotsSeeAndWhoTheyAre) {
  Fusion fusion = make_fusion();
  Eye left(1, 11);
  Eye right(4, 44);
  watch(fusion, left, kLeftOfBall, {0.0, 0.3}, see_the_ball);
  watch(fusion, right, kRightOfBall, {0.3, 0.6}, see_the_ball);

  const WorldModel world = fusion.world_at(at_second(0.61));

  ASSERT_EQ(world.balls.size(), 1U);
  EXPECT_NEAR(world.balls[0].p_FB.x, kBall.x, 0.05);
  EXPECT_NEAR(world.balls[0].p_FB.y, kBall.y, 0.05);
  EXPECT_EQ(world.balls[0].supporters, robot_bit(1) | robot_bit(4));
  EXPECT_EQ(world.balls[0].rejected, 0);
  EXPECT_GT(world.balls[0].existence, 0.9);
}

TEST(Fusion, ShowsNoBallBeforeItWasSeenThreeTimes) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);

  watch(fusion, eye, kLeftOfBall, {0.0, 0.05}, see_the_ball);
  EXPECT_TRUE(fusion.world_at(at_second(0.1)).balls.empty());

  watch(fusion, eye, kLeftOfBall, {0.1, 0.12}, see_the_ball);
  EXPECT_EQ(fusion.world_at(at_second(0.13)).balls.size(), 1U);
}

TEST(Fusion, NamesTheRobotThatSeesAnotherBall) {
  Fusion fusion = make_fusion();
  Eye left(1, 11);
  Eye right(4, 44);
  watch(fusion, left, kLeftOfBall, {0.0, 0.3}, see_the_ball);
  watch(fusion, right, kRightOfBall, {0.3, 0.4}, [](Eye& eye) { eye.see_ball({5.0, -4.0}); });

  const WorldModel world = fusion.world_at(at_second(0.41));

  ASSERT_EQ(world.balls.size(), 2U);
  for (const WorldBall& ball : world.balls) {
    const bool is_first = ball.p_FB.x < 3.0;
    EXPECT_EQ(ball.supporters, robot_bit(is_first ? 1 : 4));
    EXPECT_EQ(ball.rejected & robot_bit(4), is_first ? robot_bit(4) : 0);
  }
}

TEST(Fusion, ForgetsABallThatNobodySeesAnyMore) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  watch(fusion, eye, kLeftOfBall, {0.0, 0.3}, see_the_ball);
  const double sure = fusion.world_at(at_second(0.3)).balls.at(0).existence;

  // It looks, sees nothing there, and would have.
  watch(fusion, eye, kLeftOfBall, {0.3, 0.5}, [](Eye&) {});
  const auto doubtful = fusion.world_at(at_second(0.5)).balls;
  watch(fusion, eye, kLeftOfBall, {0.5, 1.5}, [](Eye&) {});

  ASSERT_EQ(doubtful.size(), 1U);
  EXPECT_LT(doubtful[0].existence, sure);
  EXPECT_TRUE(fusion.world_at(at_second(1.5)).balls.empty());
}

TEST(Fusion, ABallWithoutAnyObserverAgesAndLeaves) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  watch(fusion, eye, kLeftOfBall, {0.0, 0.3}, see_the_ball);

  const WorldBall young = fusion.world_at(at_second(0.4)).balls.at(0);
  const WorldBall old = fusion.world_at(at_second(1.4)).balls.at(0);

  EXPECT_EQ(old.age - young.age, seconds(1));
  EXPECT_GT(old.cov_p(0, 0), young.cov_p(0, 0));
  EXPECT_EQ(old.supporters, 0);
  EXPECT_TRUE(fusion.world_at(at_second(5.0)).balls.empty());
}

TEST(Fusion, DoesNotMissABallBehindAnObstacle) {
  Fusion hidden = make_fusion();
  Fusion open = make_fusion();
  for (Fusion* fusion : {&hidden, &open}) {
    Eye eye(1, 11);
    watch(*fusion, eye, kLeftOfBall, {0.0, 0.3}, see_the_ball);
    watch(*fusion, eye, kLeftOfBall, {0.3, 0.6}, [&](Eye& looking) {
      if (fusion == &hidden) looking.see_obstacle({-0.5, 0.25});
    });
  }

  ASSERT_EQ(hidden.world_at(at_second(0.6)).balls.size(), 1U);
  const auto in_the_open = open.world_at(at_second(0.6)).balls;
  EXPECT_TRUE(in_the_open.empty() ||
              in_the_open[0].existence < hidden.world_at(at_second(0.6)).balls[0].existence);
}

TEST(Fusion, MakesNoObstacleOfATeammate) {
  Fusion fusion = make_fusion();
  Eye left(1, 11);
  Eye right(4, 44);
  for (int i = 0; i < 16; ++i) {
    const double t = 0.033 * i;
    right.look(kRightOfBall, at_second(t));
    fusion.insert(right.frame(), at_second(t));
    left.look(kLeftOfBall, at_second(t + 0.01));
    left.see_obstacle(kRightOfBall.origin());
    left.see_obstacle({0.0, -2.0});
    fusion.insert(left.frame(), at_second(t + 0.01));
  }

  const WorldModel world = fusion.world_at(at_second(0.5));

  ASSERT_EQ(world.obstacles.size(), 1U);
  EXPECT_NEAR(world.obstacles[0].p_FO.x, 0.0, 0.05);
  EXPECT_NEAR(world.obstacles[0].p_FO.y, -2.0, 0.05);
  EXPECT_NEAR(world.obstacles[0].radius, 0.25, 0.01);
  EXPECT_EQ(world.obstacles[0].supporters, robot_bit(1));
}

TEST(Fusion, BelievesNothingFarOffTheCarpet) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  watch(fusion, eye, {8.0, 0.0, 0.0}, {0.0, 0.5}, [](Eye& looking) {
    looking.see_ball({13.5, 0.0});
    looking.see_obstacle({8.0, 9.0});
  });

  const WorldModel world = fusion.world_at(at_second(0.5));

  EXPECT_TRUE(world.balls.empty());
  EXPECT_TRUE(world.obstacles.empty());
}

TEST(Fusion, ShowsAnAmbiguousTeammateButDoesNotUseWhatItSees) {
  Fusion fusion = make_fusion();
  Eye eye(2, 22);
  watch(fusion, eye, {0.0, 0.0, 1.0}, {0.0, 0.5}, [](Eye& looking) {
    looking.frame().posture.status = PostureStatus::kAmbiguous;
    looking.see_ball(kBall);
  });

  const WorldModel world = fusion.world_at(at_second(0.5));

  ASSERT_EQ(world.teammates.size(), 1U);
  EXPECT_EQ(world.teammates[0].status, PostureStatus::kAmbiguous);
  EXPECT_NEAR(world.teammates[0].X_FR.x(), 0.0, 0.01);
  EXPECT_EQ(world.teammates[0].quarantine, Quarantine::kNoPosture);
  EXPECT_DOUBLE_EQ(world.teammates[0].trust, 0.0);
  EXPECT_TRUE(world.teammates[0].sees_ball);
  EXPECT_TRUE(world.balls.empty());
}

TEST(Fusion, UsesAnAmbiguousTeammateWhoseOwnEvidenceNamesTheHalf) {
  Fusion fusion = make_fusion();
  Eye eye(2, 22);
  watch(fusion, eye, kLeftOfBall, {0.0, 0.5}, [](Eye& looking) {
    looking.frame().posture.status = PostureStatus::kAmbiguous;
    looking.frame().posture.half_log_odds = 4.0;
    looking.see_ball(kBall);
  });

  EXPECT_EQ(fusion.world_at(at_second(0.5)).balls.size(), 1U);
}

TEST(Fusion, ListsATeammateThatWasNeverLocatedAsLost) {
  Fusion fusion = make_fusion();
  Eye eye(2, 22);
  watch(fusion, eye, kLeftOfBall, {0.0, 0.1}, [](Eye& looking) {
    looking.frame().posture = PostureEstimate{};
  });

  const auto mates = fusion.world_at(at_second(0.1)).teammates;

  ASSERT_EQ(mates.size(), 1U);
  EXPECT_EQ(mates[0].status, PostureStatus::kLost);
  EXPECT_EQ(mates[0].quarantine, Quarantine::kNoPosture);
  EXPECT_GT(mates[0].cov(0, 0), 10.0);
}

TEST(Fusion, RefusesDuplicatesTheTooOldAndTheFuture) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  eye.look(kLeftOfBall, at_second(1.0));
  const Observation first = eye.frame();
  eye.look(kLeftOfBall, at_second(2.0));
  const Observation second = eye.frame();

  EXPECT_EQ(fusion.insert(second, at_second(1.9)), Intake::kFromTheFuture);
  EXPECT_EQ(fusion.insert(second, at_second(2.0)), Intake::kAccepted);
  EXPECT_EQ(fusion.insert(second, at_second(2.01)), Intake::kDuplicate);
  EXPECT_EQ(fusion.insert(first, at_second(2.02)), Intake::kTooOld);

  const RobotReport report = fusion.report_at(at_second(2.1)).robots.at(0);
  EXPECT_EQ(report.rejected_duplicate, 1U);
  EXPECT_EQ(report.rejected_late, 2U);
}

TEST(Fusion, RefusesADuplicateThatIsAlreadyFoldedAway) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  eye.look(kLeftOfBall, at_second(1.0));
  const Observation first = eye.frame();
  fusion.insert(first, at_second(1.0));
  eye.look(kLeftOfBall, at_second(2.0));
  fusion.insert(eye.frame(), at_second(2.0));

  // The same frame with another conversion of its stamp: still the same frame.
  Observation again = first;
  again.exposure = at_second(1.9);

  EXPECT_EQ(fusion.insert(again, at_second(2.0)), Intake::kTooOld);
  EXPECT_EQ(fusion.held(), 1U);
}

TEST(Fusion, TakesARobotWhoseNumberWasForgedFarAhead) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  eye.look(kLeftOfBall, at_second(1.0));
  Observation forged = eye.frame();
  forged.id.sequence += 100'000;
  fusion.insert(forged, at_second(1.0));
  eye.look(kLeftOfBall, at_second(2.0));
  fusion.insert(eye.frame(), at_second(2.0));  // folds the forged one away

  eye.look(kLeftOfBall, at_second(2.05));

  EXPECT_EQ(fusion.insert(eye.frame(), at_second(2.05)), Intake::kAccepted);
}

TEST(Fusion, LeavesTheOthersUnharmedWhenOneBabblesTenThousandTimesASecond) {
  Fusion fusion = make_fusion();
  Eye babbler(1, 11);
  Eye other(2, 22);
  for (int i = 0; i < 5000; ++i) {
    const double t = 1.0 + 0.0001 * i;
    babbler.look(kLeftOfBall, at_second(t));
    const Intake intake = fusion.insert(babbler.frame(), at_second(t));
    EXPECT_TRUE(intake == Intake::kAccepted || intake == Intake::kTooMany);
    if (i % 400 != 0) continue;
    other.look(kRightOfBall, at_second(t));
    other.see_ball(kBall);
    EXPECT_EQ(fusion.insert(other.frame(), at_second(t)), Intake::kAccepted);
  }

  const WorldModel world = fusion.world_at(at_second(1.5));

  EXPECT_LE(fusion.held(), 60U);
  EXPECT_EQ(world.balls.size(), 1U);
  EXPECT_EQ(world.teammates.at(0).quarantine, Quarantine::kBabbling);
  EXPECT_EQ(world.teammates.at(1).quarantine, Quarantine::kNone);
}

TEST(Fusion, ExplainsItsTracks) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  watch(fusion, eye, kLeftOfBall, {0.0, 0.5}, see_the_ball);

  const Report report = fusion.report_at(at_second(0.5));

  ASSERT_EQ(report.tracks.size(), 1U);
  EXPECT_TRUE(report.tracks[0].is_ball);
  EXPECT_EQ(report.tracks[0].track, fusion.world_at(at_second(0.5)).balls.at(0).track);
  EXPECT_EQ(report.tracks[0].born_ago, milliseconds(500));
  EXPECT_LT(report.tracks[0].nis, 1.0);
  ASSERT_EQ(report.robots.size(), 1U);
  EXPECT_EQ(report.robots[0].accepted, 16U);
}

}  // namespace
}  // namespace teamsight::fusion
