// tests/geometry/angle_test.cpp: every angle is in (-pi, pi], exactly.
#include "geometry/angle.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace teamsight {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(WrapAngle, KeepsWhatIsInRange) {
  for (const double angle : {-3.1, -1.0, 0.0, 2.0, 3.1}) EXPECT_EQ(wrap_angle(angle), angle);
}

TEST(WrapAngle, KeepsPiAndTurnsMinusPiIntoPi) {
  EXPECT_EQ(wrap_angle(kPi), kPi);
  EXPECT_EQ(wrap_angle(-kPi), kPi);
}

TEST(WrapAngle, StaysInRangeAtTheNeighboursOfPi) {
  for (const double start : {-3.0 * kPi, -kPi, kPi, 3.0 * kPi}) {
    for (const double towards : {-10.0, 10.0}) {
      const double wrapped = wrap_angle(std::nextafter(start, towards));
      EXPECT_GT(wrapped, -kPi);
      EXPECT_LE(wrapped, kPi);
      EXPECT_NEAR(std::abs(wrapped), kPi, 1e-14);
    }
  }
}

TEST(WrapAngle, TakesAwayWholeTurns) {
  EXPECT_NEAR(wrap_angle(7.0 * kPi + 0.25), -kPi + 0.25, 1e-12);
  EXPECT_NEAR(wrap_angle(-100.0 * kPi - 0.5), -0.5, 1e-12);
}

TEST(WrapAngle, KeepsWhatIsNotFinite) {
  EXPECT_TRUE(std::isnan(wrap_angle(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_FALSE(std::isfinite(wrap_angle(std::numeric_limits<double>::infinity())));
}

TEST(AngleDifference, GoesTheShorterWayAcrossPi) {
  EXPECT_NEAR(angle_difference(-3.0, 3.0), 2.0 * kPi - 6.0, 1e-12);
  EXPECT_NEAR(angle_difference(3.0, -3.0), 6.0 - 2.0 * kPi, 1e-12);
}

TEST(AngleDifference, OfOppositeDirectionsIsPiBothWays) {
  EXPECT_EQ(angle_difference(kPi, 0.0), kPi);
  EXPECT_EQ(angle_difference(0.0, kPi), kPi);
}

}  // namespace
}  // namespace teamsight
