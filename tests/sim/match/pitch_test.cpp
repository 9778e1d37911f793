// tests/sim/match/pitch_test.cpp: balls stay on the carpet, in nets and out of posts.
#include "sim/match/pitch.hpp"

#include <gtest/gtest.h>

#include "tests/sim/match/fields.hpp"

namespace teamsight::sim {
namespace {

constexpr double kRadius = 0.11;

Ball rolled(Ball ball, double seconds) {
  const Pitch pitch(plain_field());
  for (int i = 0; i < static_cast<int>(seconds * 100.0); ++i) {
    const Point3<Field> before = ball.p_FB;
    ball = pitch.kept(before, moved(ball, 0.01, {}), kRadius);
  }
  return ball;
}

TEST(Pitch, BoardsThrowABallBack) {
  const Ball ball = rolled({{8.0, 6.0, kRadius}, {0.0, 5.0, 0.0}, 0}, 1.0);

  EXPECT_LT(ball.v_FB.y, -1.0);
  EXPECT_LE(ball.p_FB.y, 8.0 - kRadius);
}

TEST(Pitch, ANetHoldsAShot) {
  for (const double height : {kRadius, 0.5}) {
    const Ball ball = rolled({{10.0, 0.5, height}, {9.0, 0.0, 1.0}, 0}, 2.0);

    EXPECT_GT(ball.p_FB.x, 11.0);
    EXPECT_LE(ball.p_FB.x, 11.5 - kRadius + 1e-9);
    EXPECT_NEAR(ball.p_FB.y, 0.5, 0.2);
  }
}

TEST(Pitch, APostThrowsAShotBackIntoTheField) {
  const Ball ball = rolled({{10.0, 0.98, kRadius}, {9.0, 0.0, 0.0}, 0}, 0.3);

  EXPECT_LT(ball.p_FB.x, 11.0);
  EXPECT_LT(ball.v_FB.x, -3.0);
}

TEST(Pitch, ABallFlyingOverTheBarPassesTheGoal) {
  const Ball ball = rolled({{10.0, 0.0, 1.5}, {9.0, 0.0, 0.0}, 0}, 0.15);

  EXPECT_GT(ball.p_FB.x, 11.2);
  EXPECT_GT(ball.v_FB.x, 8.0);
}

TEST(Pitch, ANetCannotBeEnteredFromBehind) {
  const Ball ball = rolled({{11.25, 2.0, kRadius}, {0.0, -4.0, 0.0}, 0}, 0.5);

  EXPECT_GT(ball.p_FB.y, 1.0);
  EXPECT_GT(ball.v_FB.y, 0.0);
}

}  // namespace
}  // namespace teamsight::sim
