// tests/vision/localisation/half_odds_test.cpp: compass and coloured goals tell the halves apart.
#include "vision/localisation/half_odds.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/localisation/fields.hpp"

namespace teamsight::vision {
namespace {

FieldModel field_with(GoalColour own, GoalColour opponent) {
  FieldModel field = league_field();
  field.goals.push_back({"own", {-11, 1}, {-11, -1}, 1.0, 0.5, own});
  field.goals.push_back({"opponent", {11, -1}, {11, 1}, 1.0, 0.5, opponent});
  return field;
}

TEST(HalfOddsFromCompass, AgreeWithTheHeadingAndChangeSignWithTheImage) {
  const Pose<Field, Robot> X_FR(2.0, 1.0, 3.0);
  const CompassReading compass{{}, -3.1, 0.3};

  const double odds = half_log_odds_from_compass(X_FR, compass);

  EXPECT_GT(odds, 3.0);
  EXPECT_NEAR(half_log_odds_from_compass(mirrored(X_FR), compass), -odds, 1e-9);
}

TEST(HalfOddsFromCompass, SayNothingAtARightAngle) {
  EXPECT_NEAR(half_log_odds_from_compass({0, 0, std::numbers::pi / 2}, {{}, 0.0, 0.3}), 0.0, 1e-9);
}

TEST(HalfOddsFromGoals, KnowTheColouredGoal) {
  const FieldModel field = field_with(GoalColour::kBlue, GoalColour::kYellow);
  const Pose<Field, Robot> X_FR(2.0, 0.0, 0.0);
  const std::vector<GoalBearing> ahead{{GoalColour::kYellow, 0.05, 0.1}};
  const std::vector<GoalBearing> behind{{GoalColour::kYellow, std::numbers::pi, 0.1}};

  EXPECT_GT(half_log_odds_from_goals(X_FR, field, ahead), 2.0);
  EXPECT_LT(half_log_odds_from_goals(X_FR, field, behind), -2.0);
}

TEST(HalfOddsFromGoals, SayNothingOfWhiteGoals) {
  const FieldModel field = field_with(GoalColour::kWhite, GoalColour::kWhite);
  const std::vector<GoalBearing> ahead{{GoalColour::kWhite, 0.0, 0.1}};

  EXPECT_DOUBLE_EQ(half_log_odds_from_goals({2.0, 0.0, 0.0}, field, ahead), 0.0);
}

MotionPrior expected_at(const Pose<Field, Robot>& X_FR, double half_log_odds) {
  const Eigen::Vector3d sigma(0.01, 0.01, 0.005);
  return {.X_FR = X_FR, .cov = sigma.cwiseAbs2().asDiagonal(), .half_log_odds = half_log_odds};
}

TEST(HalfOddsAfterJump, KeepTheHalfWhereAPushExplainsThePlace) {
  const MotionPrior expected = expected_at({5.0, 3.0, 1.0}, 3.0);
  const Pose<Field, Robot> beside(5.3, 3.2, 1.2);

  EXPECT_NEAR(half_log_odds_after_jump(beside, expected, 0.4, league_field()), 3.0, 0.1);
  EXPECT_NEAR(half_log_odds_after_jump(mirrored(beside), expected, 0.4, league_field()), -3.0, 0.1);
}

TEST(HalfOddsAfterJump, SayNothingWhereOnlyCarryingExplainsThePlace) {
  const MotionPrior expected = expected_at({5.0, 3.0, 1.0}, kMaxHalfLogOdds);
  const Pose<Field, Robot> too_far(6.0, 3.4, 1.2);

  EXPECT_NEAR(half_log_odds_after_jump(too_far, expected, 0.4, league_field()), 0.0, 0.01);
  EXPECT_NEAR(
      half_log_odds_after_jump(mirrored(too_far), expected, 0.4, league_field()), 0.0, 0.01);
}

TEST(HalfOddsAfterJump, SayLessTheFurtherAPushMayHaveReached) {
  const MotionPrior expected = expected_at({5.0, 3.0, 1.0}, kMaxHalfLogOdds);
  const Pose<Field, Robot> beside(6.0, 3.4, 1.2);

  const double soon = half_log_odds_after_jump(beside, expected, 3.0, league_field());
  const double late = half_log_odds_after_jump(beside, expected, 15.0, league_field());

  EXPECT_GT(soon, 3.0);
  EXPECT_LT(late, 1.0);
  EXPECT_GT(late, 0.0);
}

TEST(HalfOddsAfterJump, KeepTheHalfWhereTheExpectationItselfWasThatUnsure) {
  MotionPrior expected = expected_at({5.0, 3.0, 1.0}, kMaxHalfLogOdds);
  expected.cov.diagonal() << 0.25, 0.25, 0.04;

  EXPECT_GT(half_log_odds_after_jump({5.8, 3.3, 1.2}, expected, 15.0, league_field()), 3.0);
}

}  // namespace
}  // namespace teamsight::vision
