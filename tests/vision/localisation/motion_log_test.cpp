// tests/vision/localisation/motion_log_test.cpp: steps between readings, and readings that are bad.
#include "vision/localisation/motion_log.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

HostTime at(double seconds) {
  return HostTime{from_seconds(seconds)};
}

WheelReading wheels(double seconds, double x, double v = 0.0) {
  WheelReading reading;
  reading.stamp = at(seconds);
  reading.X_DR = {x, 0.0, 0.0};
  reading.v_R = {v, 0.0};
  return reading;
}

TEST(MotionLog, InterpolatesBetweenTwoCounts) {
  MotionLog log;
  log.roll(wheels(10.0, 0.0));
  log.roll(wheels(10.1, 1.0));

  const auto walk = log.walk(at(10.0), at(10.03), false);

  ASSERT_TRUE(walk.has_value());
  EXPECT_NEAR(walk->step.x(), 0.3, 1e-9);
}

TEST(MotionLog, GoesOnForATenthOfASecondAtTheLastVelocity) {
  MotionLog log;
  log.roll(wheels(10.0, 0.0, 2.0));

  ASSERT_TRUE(log.walk(at(10.0), at(10.05), false).has_value());
  EXPECT_NEAR(log.walk(at(10.0), at(10.05), false)->step.x(), 0.1, 1e-9);
  EXPECT_FALSE(log.walk(at(10.0), at(10.2), false).has_value());
}

TEST(MotionLog, IsMuchLessSureWhileSlipping) {
  MotionLog log;
  log.roll(wheels(10.0, 0.0));
  log.roll(wheels(10.1, 0.1));

  const double firm = log.walk(at(10.0), at(10.1), false)->cov(0, 0);
  const double slipping = log.walk(at(10.0), at(10.1), true)->cov(0, 0);

  EXPECT_GT(slipping, 100.0 * firm);
}

TEST(MotionLog, TakesTheTurnFromTheGyroWhereThereIsOne) {
  MotionLog log;
  for (int i = 0; i <= 10; ++i) {
    WheelReading reading = wheels(10.0 + 0.01 * i, 0.0);
    reading.X_DR = {0.0, 0.0, 0.005 * i};  // wheels say 0.5 rad/s
    log.roll(reading);
    log.turn({at(10.0 + 0.01 * i), 1.0, 0.001});
  }

  const auto walk = log.walk(at(10.0), at(10.1), false);

  ASSERT_TRUE(walk.has_value());
  EXPECT_NEAR(walk->step.theta(), 0.1, 0.002);
}

TEST(MotionLog, MeasuresTheAcceleration) {
  MotionLog log;
  for (int i = 0; i <= 30; ++i) log.roll(wheels(10.0 + 0.01 * i, 0.0, 2.5 * 0.01 * i));

  ASSERT_TRUE(log.acceleration(at(10.3)).has_value());
  EXPECT_NEAR(log.acceleration(at(10.3))->x(), 2.5, 1e-6);
}

TEST(MotionLog, DropsWhatIsNotFinite) {
  MotionLog log;
  WheelReading reading = wheels(10.0, 0.0);
  reading.omega = std::numeric_limits<double>::quiet_NaN();

  EXPECT_EQ(log.roll(reading), InputReject::kNotFinite);
  EXPECT_EQ(log.turn({at(10.0), std::numeric_limits<double>::infinity(), 0.1}),
            InputReject::kNotFinite);
  EXPECT_FALSE(log.newest(at(10.0)).has_value());
}

TEST(MotionLog, BeginsAgainWhenTheDrivesClockDid) {
  MotionLog log;
  log.roll(wheels(1000.0, 0.0));
  int dropped = 0;
  for (int i = 0; i < 40; ++i) {
    if (log.roll(wheels(10.0 + 0.01 * i, 0.0)) == InputReject::kBackwards) ++dropped;
  }

  EXPECT_EQ(dropped, 19);
  EXPECT_TRUE(log.newest(at(10.4)).has_value());
}

}  // namespace
}  // namespace teamsight::vision
