// tests/vision/localisation/hypothesis_test.cpp: prediction, correction, mirror images, merging.
#include "vision/localisation/hypothesis.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/uncertainty.hpp"

namespace teamsight::vision {
namespace {

Hypothesis standing_at(double x, double y, double theta) {
  Hypothesis hypothesis;
  hypothesis.X_FR = {x, y, theta};
  hypothesis.cov = 0.01 * Matrix6::Identity();
  return hypothesis;
}

// Turns a small change of (x, y, theta) into the change after coasting, numerically.
Eigen::Matrix3d numeric_jacobian(const Hypothesis& start, double seconds) {
  Eigen::Matrix3d jacobian;
  constexpr double kNudge = 1e-6;
  for (int k = 0; k < 3; ++k) {
    Hypothesis plus = start;
    Hypothesis minus = start;
    const Eigen::Vector3d nudge = kNudge * Eigen::Vector3d::Unit(k);
    const Eigen::Vector3d at = start.X_FR.vector();
    plus.X_FR = {at.x() + nudge.x(), at.y() + nudge.y(), at.z() + nudge.z()};
    minus.X_FR = {at.x() - nudge.x(), at.y() - nudge.y(), at.z() - nudge.z()};
    coast(plus, seconds, {});
    coast(minus, seconds, {});
    Eigen::Vector3d change = plus.X_FR.vector() - minus.X_FR.vector();
    change.z() = wrap_angle(change.z());
    jacobian.col(k) = change / (2.0 * kNudge);
  }
  return jacobian;
}

TEST(Coast, CarriesTheCovarianceByTheNumericalJacobian) {
  for (const double theta : {0.0, 1e-9, 1.2, 3.1415, -3.1415}) {
    Hypothesis start = standing_at(1.0, 2.0, theta);
    start.v_R = {1.5, -0.7};
    start.omega = 0.8;
    start.cov.bottomRightCorner<3, 3>() *= 1e-9;
    const Eigen::Matrix3d F = numeric_jacobian(start, 0.1);
    DriveLimits still;
    still.sigma_acceleration = 1e-9;
    still.sigma_turn_acceleration = 1e-9;

    Hypothesis later = start;
    coast(later, 0.1, still);

    const Eigen::Matrix3d expected = F * start.cov_pose() * F.transpose();
    EXPECT_LT((later.cov_pose() - expected).norm(), 1e-8) << "theta " << theta;
  }
}

TEST(Carry, FollowsTheWheels) {
  Hypothesis hypothesis = standing_at(1.0, 0.0, M_PI / 2.0);
  Walk walk;
  walk.step = {0.4, 0.0, 0.1};
  walk.cov = 1e-4 * Eigen::Matrix3d::Identity();

  carry(hypothesis, walk, {});

  EXPECT_NEAR(hypothesis.X_FR.x(), 1.0, 1e-12);
  EXPECT_NEAR(hypothesis.X_FR.y(), 0.4, 1e-12);
  EXPECT_GT(hypothesis.cov(0, 0), 0.01);
  EXPECT_TRUE(is_covariance(hypothesis.cov));
}

TEST(Correct, MeetsTwoEqualBeliefsInTheMiddleAcrossTheCut) {
  Hypothesis hypothesis = standing_at(0.0, 0.0, 3.1);

  correct(hypothesis, {0.2, 0.0, -3.1}, 0.01 * Eigen::Matrix3d::Identity());

  EXPECT_NEAR(hypothesis.X_FR.x(), 0.1, 1e-9);
  EXPECT_NEAR(std::abs(hypothesis.X_FR.theta()), M_PI, 1e-9);
  EXPECT_NEAR(hypothesis.cov(0, 0), 0.005, 1e-9);
}

TEST(Correct, MeasuresTheVelocityFromPostures) {
  Hypothesis hypothesis = standing_at(0.0, 0.0, 0.5);
  hypothesis.cov.diagonal().tail<3>().setConstant(4.0);
  const Pose<Field, Robot> start = hypothesis.X_FR;
  for (int i = 1; i <= 60; ++i) {
    coast(hypothesis, 1.0 / 30.0, {});
    const Pose<Field, Robot> seen = start * Pose<Robot, Robot>(i / 30.0, 0.0, 0.0);
    correct(hypothesis, seen, 1e-5 * Eigen::Matrix3d::Identity());
  }

  EXPECT_NEAR(hypothesis.v_R.x, 1.0, 0.02);
  EXPECT_NEAR(hypothesis.v_R.y, 0.0, 0.02);
}

TEST(Mirrored, GivesBackTheSameWhenDoneTwice) {
  Hypothesis hypothesis = standing_at(3.0, -1.0, 0.7);
  hypothesis.half_log_odds = 2.0;
  hypothesis.cov(0, 2) = hypothesis.cov(2, 0) = 0.003;
  hypothesis.cov(1, 4) = hypothesis.cov(4, 1) = -0.002;

  const Hypothesis image = mirrored(hypothesis, {});
  const Hypothesis again = mirrored(image, {});

  EXPECT_DOUBLE_EQ(image.half_log_odds, -2.0);
  EXPECT_DOUBLE_EQ(image.cov(0, 2), -0.003);
  EXPECT_LT((again.cov - hypothesis.cov).norm(), 1e-15);
  EXPECT_NEAR(again.X_FR.x(), 3.0, 1e-12);
}

TEST(Belief, MergesMirrorImagesOfASymmetricField) {
  Belief belief;
  belief.add(standing_at(3.0, 1.0, 0.5));
  Hypothesis image = mirrored(standing_at(3.05, 1.0, 0.5), {});
  image.log_weight = -1.0;
  belief.add(image);
  Belief apart = belief;

  belief.tidy(true, {});
  apart.tidy(false, {});

  EXPECT_EQ(belief.count, 1U);
  EXPECT_EQ(apart.count, 2U);
  EXPECT_NEAR(apart.share_of_best(), 1.0 / (1.0 + std::exp(-1.0)), 1e-9);
}

}  // namespace
}  // namespace teamsight::vision
