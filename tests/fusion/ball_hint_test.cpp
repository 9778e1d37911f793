// tests/fusion/ball_hint_test.cpp: what the operator's word about the ball changes, and what not.
#include "fusion/ball_hint.hpp"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fusion/fusion.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::at_second;
using test::Eye;

const Point<Field> kBall{3.0, 2.0};
const Point<Field> kOrangeThing{-3.0, -2.0};
constexpr double kFrame = 0.04;  // s

BallHint hint_at(const Point<Field>& p_FB, double second, std::uint32_t number = 7) {
  return {number, at_second(second), p_FB, 0.25 * Eigen::Matrix2d::Identity()};
}

/// Three robots see an orange thing beside the field, a fourth alone sees the ball.
class BallHints : public ::testing::Test {
 protected:
  void play(double from, double to) {
    for (double t = from; t < to; t += kFrame) {
      for (std::size_t i = 0; i < eyes_.size(); ++i) look(i, t + 0.003 * static_cast<double>(i));
    }
  }

  void look(std::size_t i, double second) {
    const bool sees_ball = i == 3 && ball_is_seen_;
    eyes_.at(i).look(places_.at(i), at_second(second));
    if (sees_ball) eyes_.at(i).see_ball(kBall);
    if (i != 3) eyes_.at(i).see_ball(kOrangeThing);
    EXPECT_EQ(fusion_.insert(eyes_.at(i).frame(), at_second(second)), Intake::kAccepted);
  }

  [[nodiscard]] Point<Field> first_ball(double second) const {
    const WorldModel world = fusion_.world_at(at_second(second));
    return world.balls.empty() ? Point<Field>{99.0, 99.0} : world.balls.front().p_FB.on_floor();
  }

  [[nodiscard]] bool is_first(const Point<Field>& p_FB, double second) const {
    return (first_ball(second).vector() - p_FB.vector()).norm() < 0.2;
  }

  Fusion fusion_{Parameters{}, test::plain_field()};
  bool ball_is_seen_{true};
  std::array<Eye, 4> eyes_{Eye(1, 11), Eye(2, 22), Eye(3, 33), Eye(4, 44)};
  std::array<Pose<Field, Robot>, 4> places_{Pose<Field, Robot>(-5.0, -2.0, 0.0),
                                            Pose<Field, Robot>(-3.0, -4.0, 1.5),
                                            Pose<Field, Robot>(-1.0, -3.0, 2.5),
                                            Pose<Field, Robot>(5.0, 3.0, -2.0)};
};

TEST_F(BallHints, PutsTheBallThatOneRobotSeesBeforeTheThingThatThreeSee) {
  play(0.0, 1.0);
  ASSERT_TRUE(is_first(kOrangeThing, 1.0));

  fusion_.take_hint(hint_at({3.4, 1.7}, 1.0));
  play(1.0, 1.1);

  EXPECT_TRUE(is_first(kBall, 1.1));
  const HintReport report = fusion_.report_at(at_second(1.1)).hint;
  EXPECT_EQ(report.number, 7U);
  EXPECT_EQ(report.track, fusion_.world_at(at_second(1.1)).balls.front().track);
  EXPECT_NEAR(to_seconds(report.left), 7.9, 1e-6);
}

TEST_F(BallHints, FadesUntilTheRobotsOutweighItAndEnds) {
  play(0.0, 1.0);
  fusion_.take_hint(hint_at(kBall, 1.0));

  play(1.0, 5.0);
  EXPECT_TRUE(is_first(kBall, 5.0));

  play(5.0, 8.5);
  EXPECT_TRUE(is_first(kOrangeThing, 8.5));
  play(8.5, 9.2);
  EXPECT_EQ(fusion_.report_at(at_second(9.2)).hint.left, Duration{0});
}

TEST_F(BallHints, MakesNoBallWhereNoneIsSeen) {
  ball_is_seen_ = false;
  play(0.0, 1.0);

  fusion_.take_hint(hint_at(kBall, 1.0));
  play(1.0, 2.0);

  EXPECT_EQ(fusion_.world_at(at_second(2.0)).balls.size(), 1U);
  EXPECT_TRUE(is_first(kOrangeThing, 2.0));
  EXPECT_EQ(fusion_.report_at(at_second(2.0)).hint.track, 0U);
}

TEST_F(BallHints, ChangesTheOrderOfTheBallsAndNothingElse) {
  play(0.0, 1.0);
  Fusion untold = fusion_;
  fusion_.take_hint(hint_at(kBall, 1.0));
  for (double t = 1.0; t < 1.1; t += kFrame) {
    look(3, t);
    ASSERT_EQ(untold.insert(eyes_[3].frame(), at_second(t)), Intake::kAccepted);
  }

  const WorldModel told = fusion_.world_at(at_second(1.1));
  WorldModel other = untold.world_at(at_second(1.1));

  ASSERT_EQ(other.balls.size(), 2U);
  std::swap(other.balls[0], other.balls[1]);
  EXPECT_EQ(told, other);
}

TEST_F(BallHints, MeansTheSameBallAfterItRolledAway) {
  play(0.0, 1.0);
  fusion_.take_hint(hint_at(kBall, 1.0));
  play(1.0, 1.1);
  const std::uint32_t meant = fusion_.report_at(at_second(1.1)).hint.track;

  for (double t = 1.1; t < 3.0; t += kFrame) {
    for (std::size_t i = 0; i < 3; ++i) look(i, t + 0.003 * static_cast<double>(i));
    eyes_[3].look(places_[3], at_second(t + 0.01));
    eyes_[3].see_ball({3.0 + 1.5 * (t - 1.1), 2.0});
    ASSERT_EQ(fusion_.insert(eyes_[3].frame(), at_second(t + 0.01)), Intake::kAccepted);
  }

  EXPECT_EQ(fusion_.world_at(at_second(3.0)).balls.front().track, meant);
  EXPECT_GT(first_ball(3.0).x, 5.0);
}

TEST_F(BallHints, FindsABallThatIsSeenOnlyLater) {
  ball_is_seen_ = false;
  play(0.0, 1.0);
  fusion_.take_hint(hint_at(kBall, 1.0));
  play(1.0, 2.0);
  ASSERT_TRUE(is_first(kOrangeThing, 2.0));

  ball_is_seen_ = true;
  play(2.0, 2.5);

  EXPECT_TRUE(is_first(kBall, 2.5));
}

TEST_F(BallHints, CountsOnceHoweverOftenItIsSaid) {
  play(0.0, 1.0);
  fusion_.take_hint(hint_at(kBall, 1.0));
  play(1.0, 4.0);

  fusion_.take_hint(hint_at(kBall, 4.0));

  EXPECT_NEAR(to_seconds(fusion_.report_at(at_second(4.0)).hint.left), 5.0, 1e-6);
}

TEST_F(BallHints, GivesWayToANewerOne) {
  play(0.0, 1.0);
  fusion_.take_hint(hint_at(kBall, 1.0));
  play(1.0, 1.2);

  fusion_.take_hint(hint_at(kOrangeThing, 1.2, 8));
  play(1.2, 1.4);

  EXPECT_TRUE(is_first(kOrangeThing, 1.4));
  EXPECT_EQ(fusion_.report_at(at_second(1.4)).hint.number, 8U);
}

}  // namespace
}  // namespace teamsight::fusion
