// tests/sim/wheels_test.cpp: the wheels count the way, nearly.
#include "sim/wheels.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace teamsight::sim {
namespace {

Player driving_left_in_F() {
  // Faces +y and drives along +y: forward in R.
  return {1, Pose<Field, Robot>(0.0, 0.0, M_PI / 2.0), {0.0, 1.0}, 0.0};
}

TEST(Wheels, CountForwardWhatIsForwardInR) {
  Wheels wheels({0.0, 0.0, 0.0}, 1);
  for (int i = 0; i < 100; ++i) {
    wheels.roll(driving_left_in_F(), 0.01);
  }

  EXPECT_NEAR(wheels.pose().x(), 1.0, 1e-9);
  EXPECT_NEAR(wheels.pose().y(), 0.0, 1e-9);
  EXPECT_NEAR(wheels.velocity().x, 1.0, 1e-9);
}

TEST(Wheels, DriftApartWithDifferentSeedsOnly) {
  Wheels a({}, 1);
  Wheels same({}, 1);
  Wheels other({}, 2);
  for (int i = 0; i < 1000; ++i) {
    a.roll(driving_left_in_F(), 0.01);
    same.roll(driving_left_in_F(), 0.01);
    other.roll(driving_left_in_F(), 0.01);
  }

  EXPECT_EQ(a.pose(), same.pose());
  EXPECT_FALSE(a.pose() == other.pose());
  EXPECT_NEAR(a.pose().x(), 10.0, 1.0);
}

}  // namespace
}  // namespace teamsight::sim
