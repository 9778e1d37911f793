// tests/fusion/ball_motion_test.cpp: how a ball rolls, flies and bounces.
#include "fusion/ball_motion.hpp"

#include <gtest/gtest.h>

namespace teamsight::fusion {
namespace {

constexpr double kStep = 0.01;  // s
const BallMotion kMotion;

BallVector moving(double height, double forward, double up) {
  BallVector ball;
  ball << 0.0, 0.0, height, forward, 0.0, up;
  return ball;
}

TEST(RollingBall, StopsWhereFrictionHasUsedItsEnergy) {
  BallVector ball = moving(kMotion.radius, 3.0, 0.0);

  for (int i = 0; i < 1000; ++i) ball = step_rolling(ball, kStep, 0.0, kMotion).mean;

  EXPECT_NEAR(ball.x(), 3.0 * 3.0 / (2.0 * kMotion.friction), 0.02);
  EXPECT_EQ(ball(3), 0.0);
  EXPECT_EQ(ball.z(), kMotion.radius);
}

TEST(RollingBall, ThatLiesDoesNotBeginToMove) {
  const BallVector ball = step_rolling(moving(kMotion.radius, 0.0, 0.0), kStep, 0.0, kMotion).mean;

  EXPECT_EQ(ball, moving(kMotion.radius, 0.0, 0.0));
}

TEST(FlyingBall, FollowsAParabola) {
  BallMotion vacuum = kMotion;
  vacuum.drag = 0.0;
  BallVector ball = moving(1.0, 2.0, 4.0);

  for (int i = 0; i < 40; ++i) ball = step_flying(ball, kStep, vacuum).mean;

  EXPECT_NEAR(ball.x(), 2.0 * 0.4, 1e-9);
  EXPECT_NEAR(ball.z(), 1.0 + 4.0 * 0.4 - 0.5 * vacuum.gravity * 0.4 * 0.4, 1e-9);
  EXPECT_NEAR(ball(5), 4.0 - vacuum.gravity * 0.4, 1e-9);
}

TEST(FlyingBall, BouncesOffTheFloorSlowerAndLessSurely) {
  const BallVector down = moving(kMotion.radius + 0.01, 2.0, -3.0);

  const BallStep bounce = step_flying(down, kStep, kMotion);
  const BallStep free = step_flying(moving(2.0, 2.0, -3.0), kStep, kMotion);

  EXPECT_GT(bounce.mean.z(), kMotion.radius);
  EXPECT_NEAR(bounce.mean(5), kMotion.climb_kept * 3.1, 0.05);
  EXPECT_NEAR(bounce.mean(3), kMotion.speed_kept * 2.0, 0.01);
  EXPECT_GT(bounce.disturbance(5, 5), free.disturbance(5, 5));
}

TEST(FlyingBall, RollsWhenABounceLeavesNothing) {
  EXPECT_TRUE(step_flying(moving(kMotion.radius, 1.0, -0.3), kStep, kMotion).lands);
  EXPECT_FALSE(step_flying(moving(kMotion.radius, 1.0, -3.0), kStep, kMotion).lands);
}

TEST(LedBall, GoesOnUnbrakedAndLessSurely) {
  const BallVector ball = moving(kMotion.radius, 2.0, 0.0);

  const BallStep led = step_led(ball, kStep, kMotion);
  const BallStep free = step_rolling(ball, kStep, kMotion.rolling_psd, kMotion);

  EXPECT_EQ(led.mean(3), ball(3));
  EXPECT_LT(free.mean(3), ball(3));
  EXPECT_GT(led.disturbance(3, 3), 10.0 * free.disturbance(3, 3));
  EXPECT_EQ(led.mean(2), kMotion.radius);
}

TEST(LedBall, LedSinceAnUnknownInstantIsTheMeanOverAllInstants) {
  constexpr double kLong = 2.0;  // s
  constexpr int kInstants = 2000;
  BallMatrix mean = BallMatrix::Zero();
  for (int i = 0; i < kInstants; ++i) {
    const double led = (i + 0.5) / kInstants * kLong;
    mean += step_led(moving(kMotion.radius, 1.0, 0.0), led, kMotion).disturbance / kInstants;
  }

  const BallMatrix added = led_for_a_part(kLong, kMotion);

  for (const auto& [row, column] : {std::pair{0, 0}, {0, 3}, {4, 1}, {4, 4}, {0, 1}}) {
    EXPECT_NEAR(added(row, column), mean(row, column), 1e-4) << row << ", " << column;
  }
  EXPECT_EQ(added(2, 2), 0.0);
}

TEST(KickedBall, HasAnyVelocityFromAnInstantWithinTheStep) {
  const BallStep kick = step_kicked(
      moving(kMotion.radius, 2.0, 0.0), kStep, {BallMode::kRolling, {0.0, 0.0}, 4.0}, kMotion);

  const double changed = 4.0 * 4.0;
  EXPECT_EQ(kick.mean(3), 0.0);
  EXPECT_NEAR(kick.mean(0), -0.5 * kStep * 2.0, 1e-12);
  EXPECT_NEAR(kick.disturbance(3, 3), changed, 1e-12);
  EXPECT_NEAR(kick.disturbance(0, 0), kStep * kStep * (changed / 3.0 + 4.0 / 12.0), 1e-12);
}

TEST(KickedBall, GoesAwayFromTheFootThatKicksIt) {
  const Eigen::Vector2d away(0.0, 1.0);

  const BallStep kick = step_kicked(
      moving(kMotion.radius, 0.0, 0.0), kStep, {BallMode::kRolling, away, 4.0}, kMotion);

  // Half of a normal distribution: its mean, and what is left of its variance.
  const double var = 4.0 * 4.0;
  EXPECT_EQ(kick.mean(3), 0.0);
  EXPECT_NEAR(kick.mean(4), 0.798 * 4.0, 0.01);
  EXPECT_NEAR(kick.disturbance(3, 3), var, 1e-9);
  EXPECT_NEAR(kick.disturbance(4, 4), 0.363 * var, 0.01);
}

TEST(BallThatLeavesTheCarpet, ComesBackFromItsEdgeSlower) {
  BallMotion motion = kMotion;
  motion.carpet_centre << 0.0, 1.0;
  motion.carpet_reach << 12.0, 8.0;
  BallVector ball = moving(1.5, 6.0, 2.0);
  ASSERT_FALSE(step_rebound(ball, motion).has_value());
  ball(0) = 12.4;

  const auto rebound = step_rebound(ball, motion);

  ASSERT_TRUE(rebound.has_value());
  EXPECT_EQ(rebound->mean(0), 12.0);
  EXPECT_EQ(rebound->mean(1), ball(1));
  EXPECT_EQ(rebound->mean(2), ball(2));
  EXPECT_NEAR(rebound->mean(3), -motion.rebound_kept * ball(3), 1e-12);
  EXPECT_EQ(rebound->mean(5), ball(5));
  EXPECT_GT(rebound->disturbance(3, 3), 1.0);
  EXPECT_FALSE(rebound->lands);

  ball = rebound->mean;
  ball(0) = 12.01;
  EXPECT_EQ(step_rebound(ball, motion)->mean(3), ball(3)) << "on its way back";
}

}  // namespace
}  // namespace teamsight::fusion
