// tests/geometry/identity_test.cpp: robots as bits, frames as names.
#include "geometry/identity.hpp"

#include <gtest/gtest.h>

namespace teamsight {
namespace {

TEST(RobotBit, IsDifferentForEveryRobot) {
  RobotMask all = 0;

  for (RobotId robot = 1; robot <= kMaxRobotId; ++robot) {
    EXPECT_EQ(all & robot_bit(robot), 0) << int{robot};
    all = static_cast<RobotMask>(all | robot_bit(robot));
  }

  EXPECT_EQ(all, 0xFFFF);
}

TEST(RobotBit, IsNoneForNobodyAndForWhoIsNoRobot) {
  EXPECT_EQ(robot_bit(kNobody), 0);
  EXPECT_EQ(robot_bit(17), 0);
  EXPECT_EQ(robot_bit(255), 0);
}

TEST(ObservationId, OrdersByRobotThenBootThenSequence) {
  EXPECT_LT((ObservationId{1, 9, 9}), (ObservationId{2, 1, 1}));
  EXPECT_LT((ObservationId{1, 1, 9}), (ObservationId{1, 2, 1}));
  EXPECT_LT((ObservationId{1, 1, 1}), (ObservationId{1, 1, 2}));
}

}  // namespace
}  // namespace teamsight
