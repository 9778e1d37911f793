// tests/sim/match/ball_test.cpp: rolling and flying against closed forms.
#include "sim/match/ball.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace teamsight::sim {
namespace {

Ball after(Ball ball, double seconds, const BallParameters& parameters) {
  const int steps = static_cast<int>(std::lround(seconds / 0.01));
  for (int i = 0; i < steps; ++i) {
    ball = moved(ball, 0.01, parameters);
  }
  return ball;
}

BallParameters without_air() {
  BallParameters parameters;
  parameters.drag = 0.0;
  return parameters;
}

TEST(Ball, RollsUntilFrictionStopsIt) {
  // v^2 / 2a = 4 / 0.9
  const Ball rolling{{0.0, 0.0, 0.11}, {2.0, 0.0, 0.0}, 0};

  const Ball stopped = after(rolling, 10.0, without_air());

  EXPECT_NEAR(stopped.p_FB.x, 4.444, 0.02);
  EXPECT_EQ(stopped.v_FB.x, 0.0);
}

// The way of half its outline turns the ball upside down, about the axis across.
TEST(Ball, TurnsAsItRolls) {
  const BallParameters parameters;
  const Point3<Field> before{0.2, -0.1, 0.11};
  const Ball then{{0.2, -0.1 + std::numbers::pi * 0.11, 0.11}, {}, 0};

  const Eigen::Matrix3d turn_F = rolled(then, before, parameters).toRotationMatrix();

  EXPECT_TRUE(turn_F.isApprox(Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal().toDenseMatrix(), 1e-9));
  EXPECT_TRUE(rolled(then, then.p_FB, parameters).isApprox(then.turn_F));
}

TEST(Ball, FliesAParabolaWithoutAir) {
  const Ball kicked{{0.0, 0.0, 0.11}, {6.0, 0.0, 5.0}, 0};

  const Ball then = after(kicked, 0.5, without_air());

  EXPECT_NEAR(then.p_FB.x, 3.0, 1e-6);
  EXPECT_NEAR(then.p_FB.z, 0.11 + 2.5 - 0.5 * 9.81 * 0.25, 0.01);
  EXPECT_NEAR(then.v_FB.z, 5.0 - 9.81 * 0.5, 1e-6);
}

TEST(Ball, LosesSpeedToTheAirAsItsSquare) {
  // Straight on, v(t) = v0 / (1 + k v0 t); friction of the floor left out.
  BallParameters parameters;
  parameters.deceleration = 0.0;
  const Ball fast{{0.0, 0.0, 0.11}, {10.0, 0.0, 0.0}, 0};

  const Ball then = after(fast, 2.0, parameters);

  EXPECT_NEAR(then.v_FB.x, 10.0 / (1.0 + 0.015 * 10.0 * 2.0), 0.01);
}

TEST(Ball, BouncesWithAShareOfItsSpeedAndComesToRest) {
  // Falls 1 m: 4.43 m/s; 0.65 of it carry it 0.4225 m high, without air.
  BallParameters parameters = without_air();
  const Ball dropped{{0.0, 0.0, 1.11}, {}, 0};
  double highest_after = 0.0;
  Ball ball = dropped;
  for (int i = 0; i < 500; ++i) {
    const bool has_bounced = ball.v_FB.z > 0.0 || highest_after > 0.0;
    ball = moved(ball, 0.01, parameters);
    highest_after = has_bounced ? std::max(highest_after, ball.p_FB.z) : 0.0;
  }

  EXPECT_NEAR(highest_after - 0.11, 0.4225, 0.02);
  EXPECT_FALSE(is_flying(ball, parameters));
  EXPECT_EQ(ball.p_FB.z, 0.11);
}

}  // namespace
}  // namespace teamsight::sim
