// tests/agent/motion_test.cpp: the prior for the next frame.
#include "agent/motion.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/geometry_matchers.hpp"

namespace teamsight::agent {
namespace {

using testing_support::IsNear;

HostTime at(double seconds) {
  return HostTime{from_seconds(seconds)};
}

PostureEstimate posture(double x, double y, double theta) {
  PostureEstimate estimate;
  estimate.status = PostureStatus::kOk;
  estimate.X_FR = {x, y, theta};
  estimate.cov = Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
  estimate.half_log_odds = 2.0;
  return estimate;
}

bus::Odometry odometry(double seconds, double x, double theta) {
  bus::Odometry message;
  message.id = {1, 1, 1};
  message.stamp = stamp_of(at(seconds));
  message.X_DR = {x, 0.0, theta};
  return message;
}

TEST(Motion, KnowsNothingAtFirstButTheStartSide) {
  const Motion motion({}, vision::StartSide::kOwnHalf);

  EXPECT_FALSE(motion.prior_at(at(1.0)).X_FR.has_value());
  EXPECT_EQ(motion.prior_at(at(1.0)).start_side, vision::StartSide::kOwnHalf);
}

TEST(Motion, WidensTheLastPostureWithTime) {
  Motion motion({}, vision::StartSide::kUnknown);
  motion.see(posture(1.0, 2.0, 0.5), at(10.0));

  const vision::MotionPrior soon = motion.prior_at(at(10.05));
  const vision::MotionPrior later = motion.prior_at(at(10.5));

  ASSERT_TRUE(soon.X_FR.has_value() && later.X_FR.has_value());
  EXPECT_THAT(soon.X_FR->origin(), IsNear(Point<Field>{1.0, 2.0}, 1e-12));
  EXPECT_DOUBLE_EQ(soon.half_log_odds, 2.0);
  EXPECT_NEAR(soon.cov(0, 0), 1e-4 + std::pow(2.0 * 0.05, 2), 1e-9);
  EXPECT_GT(later.cov(2, 2), soon.cov(2, 2));
}

TEST(Motion, ForgetsAPostureThatSaysNothingAnyMore) {
  Motion motion({}, vision::StartSide::kUnknown);
  motion.see(posture(1.0, 2.0, 0.5), at(10.0));

  EXPECT_FALSE(motion.prior_at(at(20.0)).X_FR.has_value());
}

TEST(Motion, CarriesThePostureAlongWithTheWheels) {
  Motion motion({}, vision::StartSide::kUnknown);
  motion.roll(odometry(9.99, 5.0, 0.0));
  motion.roll(odometry(10.01, 5.0, 0.0));
  motion.see(posture(1.0, 0.0, M_PI / 2.0), at(10.0));
  motion.roll(odometry(10.20, 5.4, 0.0));

  const vision::MotionPrior prior = motion.prior_at(at(10.20));

  // 0.4 m forward in R is 0.4 m along y in F.
  ASSERT_TRUE(prior.X_FR.has_value());
  EXPECT_THAT(prior.X_FR->origin(), IsNear(Point<Field>{1.0, 0.4}, 1e-9));
  EXPECT_LT(prior.cov(0, 0), 0.01);
}

TEST(Motion, InterpolatesBetweenTwoCounts) {
  Motion motion({}, vision::StartSide::kUnknown);
  motion.roll(odometry(10.0, 0.0, 0.0));
  motion.roll(odometry(10.1, 1.0, 0.0));
  motion.see(posture(0.0, 0.0, 0.0), at(10.0));

  EXPECT_NEAR(motion.prior_at(at(10.03)).X_FR->x(), 0.3, 1e-9);
}

TEST(Motion, DoesWithoutWheelsThatWentSilent) {
  Motion motion({}, vision::StartSide::kUnknown);
  motion.roll(odometry(9.0, 0.0, 0.0));
  motion.see(posture(1.0, 0.0, 0.0), at(10.0));

  EXPECT_NEAR(motion.prior_at(at(10.1)).X_FR->x(), 1.0, 1e-12);
  EXPECT_GT(motion.prior_at(at(10.1)).cov(0, 0), 0.03);
}

TEST(Motion, IgnoresALostPosture) {
  Motion motion({}, vision::StartSide::kUnknown);
  motion.see(posture(1.0, 0.0, 0.0), at(10.0));
  PostureEstimate lost = posture(7.0, 7.0, 0.0);
  lost.status = PostureStatus::kLost;
  motion.see(lost, at(10.1));

  EXPECT_NEAR(motion.prior_at(at(10.1)).X_FR->x(), 1.0, 1e-12);
}

TEST(Motion, MeasuresTheVelocityFromPostures) {
  Motion motion({}, vision::StartSide::kUnknown);
  for (int i = 0; i <= 40; ++i) {
    motion.see(posture(0.0, 0.05 * i, M_PI / 2.0), at(10.0 + 0.05 * i));
  }

  EXPECT_THAT(motion.velocity(at(12.0)), IsNear(Velocity<Robot>{1.0, 0.0}, 1e-3));
  EXPECT_THAT(motion.velocity(at(13.0)), IsNear(Velocity<Robot>{0.0, 0.0}, 1e-12));
}

TEST(Motion, TakesAPlaceThatSomebodyNames) {
  Motion motion({}, vision::StartSide::kUnknown);
  motion.see(posture(5.0, 5.0, 0.0), at(10.0));
  motion.place({-5.0, -5.0, 1.0}, 0.01 * Eigen::Matrix3d::Identity(), at(10.02));

  const vision::MotionPrior prior = motion.prior_at(at(10.05));

  ASSERT_TRUE(prior.X_FR.has_value());
  EXPECT_NEAR(prior.X_FR->x(), -5.0, 1e-12);
  EXPECT_GT(prior.half_log_odds, 0.0);
}

}  // namespace
}  // namespace teamsight::agent
