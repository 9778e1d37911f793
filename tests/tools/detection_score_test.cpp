// tests/tools/detection_score_test.cpp: what counts as found, as false, and as neither.
#include "tools/detection_score.hpp"

#include <gtest/gtest.h>

namespace teamsight::tools {
namespace {

TEST(DetectionScore, FindsABallWithinItsRadiusOrFourPixels) {
  const ImageLabels labels{"x", {{100, 100, 10, true}, {200, 100, 2, true}}, {}, {}};

  const Tally tally = score_balls(labels, {{109, 100, true}, {204, 100, true}, {215, 100, true}});

  EXPECT_EQ(tally.labelled, 2U);
  EXPECT_EQ(tally.found, 2U);
  EXPECT_EQ(tally.wrong, 1U);
  EXPECT_DOUBLE_EQ(tally.precision(), 2.0 / 3.0);
}

TEST(DetectionScore, NeitherBlamesNorPraisesUncertainBalls) {
  const ImageLabels labels{"x", {{100, 100, 10, false}}, {}, {}};

  const Tally tally = score_balls(labels, {{100, 100, true}});

  EXPECT_EQ(tally.labelled, 0U);
  EXPECT_EQ(tally.found, 0U);
  EXPECT_EQ(tally.wrong, 0U);
}

TEST(DetectionScore, DoesNotCountWhatIsOffTheCarpetAsFalse) {
  const Tally tally = score_balls({"x", {}, {}, {}}, {{10, 10, false}});

  EXPECT_EQ(tally.wrong, 0U);
  EXPECT_EQ(tally.outside, 1U);
}

TEST(DetectionScore, TakesOneDetectionForOneRobot) {
  const ImageLabels labels{"x", {}, {{100, 100, true}, {110, 100, true}}, {}};

  const Tally tally = score_robots(labels, {{105, 100, true}});

  EXPECT_EQ(tally.found, 1U);
  EXPECT_EQ(tally.labelled, 2U);
}

TEST(DetectionScore, ExcusesObstaclesThatArePeople) {
  const ImageLabels labels{"x", {}, {}, {{100, 100, false}}};

  const Tally tally = score_robots(labels, {{135, 100, true}, {145, 100, true}});

  EXPECT_EQ(tally.wrong, 1U);
}

TEST(DetectionScore, JudgesEachObstacleForTraining) {
  const ImageLabels labels{"x", {}, {{100, 100, true}, {300, 100, false}}, {{200, 200, true}}};

  const auto verdicts = judge_robots(
      labels, {{105, 100, true}, {130, 100, true}, {230, 200, true}, {330, 100, true}});

  const std::vector<Verdict> expected{
      Verdict::kRight, Verdict::kWrong, Verdict::kExcused, Verdict::kExcused};
  EXPECT_EQ(verdicts, expected);
}

TEST(DetectionScore, JudgesEachBallForTraining) {
  const ImageLabels labels{"x", {{100, 100, 10, true}, {300, 100, 10, false}}, {}, {}};

  const auto verdicts =
      judge_balls(labels, {{108, 100, true}, {102, 100, true}, {150, 100, true}, {305, 100, true}});

  const std::vector<Verdict> expected{
      Verdict::kExcused, Verdict::kRight, Verdict::kWrong, Verdict::kExcused};
  EXPECT_EQ(verdicts, expected);
}

TEST(DetectionScore, FindsAPersonByEitherFoot) {
  const ImageLabels labels{"x", {}, {}, {{100, 100, true}, {300, 300, true}}};

  const Tally tally = score_people(labels, {}, {{135, 100, true}, {95, 100, true}});

  EXPECT_EQ(tally.labelled, 2U);
  EXPECT_EQ(tally.found, 1U);
  EXPECT_EQ(tally.wrong, 0U);
}

TEST(DetectionScore, FindsAPersonThatIsTakenForARobotButNotByARobotBeside) {
  const ImageLabels labels{"x", {}, {{100, 130, true}}, {{100, 100, true}}};
  const Detection robot{101, 128, true};

  EXPECT_EQ(score_people(labels, {robot}, {}).found, 0U);
  EXPECT_EQ(score_people(labels, {robot, {101, 99, true}}, {}).found, 1U);
  EXPECT_EQ(people_found(labels, {robot}, {}), std::vector<bool>{false});
}

TEST(DetectionScore, CountsLegsWhereNobodyStands) {
  const ImageLabels labels{"x", {}, {{100, 100, true}}, {}};

  const Tally tally = score_people(
      labels, {{300, 300, true}}, {{120, 100, true}, {200, 200, true}, {400, 100, false}});

  EXPECT_EQ(tally.wrong, 1U);
  EXPECT_EQ(tally.outside, 1U);
}

TEST(DetectionScore, KnowsWilsonsInterval) {
  const Interval interval = wilson(8, 10);  // by hand: 0.4902 ... 0.9433

  EXPECT_NEAR(interval.low, 0.4902, 1e-3);
  EXPECT_NEAR(interval.high, 0.9433, 1e-3);
  EXPECT_EQ(wilson(0, 0).low, 0.0);
  EXPECT_EQ(wilson(0, 0).high, 1.0);
}

}  // namespace
}  // namespace teamsight::tools
