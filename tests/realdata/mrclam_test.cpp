// tests/realdata/mrclam_test.cpp: five real robots with truth: what the team makes of their
// postures.
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "bench/mrclam/score.hpp"
#include "tests/realdata/folders.hpp"

namespace teamsight::mrclam {
namespace {

class RealRobots : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!test::has_data("mrclam7")) GTEST_SKIP() << "no real data in " << test::data_dir();
    logs_ = read_robot_logs(test::data_dir() / "mrclam7");
  }

  RobotLogs logs_;
};

TEST_F(RealRobots, KnowBetterWhereTheyAreAsATeam) {
  for (const PostureScore& robot : score_postures(logs_, std::nullopt)) {
    EXPECT_GT(robot.team.count(), 8000);
    EXPECT_LT(robot.team.rms(), robot.alone.rms());
    EXPECT_EQ(robot.quarantined, 0);
  }
}

TEST_F(RealRobots, StayKnownWhenOneOfThemCountsItsWheelsForAQuarterOfAnHour) {
  constexpr RobotId kBlind = 2;

  const PostureScores scores = score_postures(logs_, kBlind);

  EXPECT_GT(scores[kBlind - 1].alone.rms(), 1.0) << "lost, alone";
  for (const PostureScore& robot : scores) {
    EXPECT_TRUE(std::isfinite(robot.team.rms()));
    EXPECT_TRUE(std::isfinite(robot.nees_team.mean()));
    EXPECT_LT(robot.team.rms(), robot.alone.rms());
  }
}

}  // namespace
}  // namespace teamsight::mrclam
