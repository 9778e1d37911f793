// tests/vision/perceived_balls_test.cpp: balls in small painted pictures.
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "tests/vision/painted_frame.hpp"

namespace teamsight::vision {
namespace {

TEST(PerceivedBall, PointsItsRayAtTheBall) {
  const Point3<Robot> p_RB{1.5, -0.7, 0.11};

  const FrameObservation seen = seen_of({{-1.2, 0.8, 0.6}, p_RB, std::nullopt});

  ASSERT_EQ(seen.balls.size(), 1U);
  const BallRay& ball = seen.balls.front();
  EXPECT_LT(error_of(ball, p_RB), 0.02);
  const double distance = (p_RB.vector() - ball.ray_R.origin.vector()).norm();
  EXPECT_NEAR(ball.angular_radius, std::asin(0.11 / distance), 0.02);
  EXPECT_GT(ball.confidence, 0.5);
  EXPECT_EQ(ball.colour, BallColour::kOrange);
}

TEST(PerceivedBall, KnowsWhatMakesABallOnTheCarpetOne) {
  const Point3<Robot> p_RB{1.5, -0.7, 0.11};

  const FrameObservation seen = seen_of({{-1.2, 0.8, 0.6}, p_RB, std::nullopt});

  ASSERT_EQ(seen.ball_pixels.size(), 1U);
  EXPECT_TRUE(seen.ball_pixels[0].on_carpet);
  const auto [too_small, too_large, roundness, ground, inside_carpet, contrast] =
      seen.ball_pixels[0].traits;
  EXPECT_LT(too_small + too_large, 0.1);  // within a third
  EXPECT_GT(roundness, 0.7);
  EXPECT_GT(ground, 0.9);
  EXPECT_GT(inside_carpet, 0.5);                                         // ten pixels
  EXPECT_NEAR(contrast, std::log(std::hypot(61 - 101, 200 - 94)), 0.2);  // orange on green
}

TEST(PerceivedBall, TakesBothSidesOfAMaskedStrutForOneBall) {
  const Point3<Robot> p_RB{0.7, 0.0, 0.11};
  CameraParameters camera = small_camera();
  // Forward is up in the picture: a strut of five pixels over the middle of the ball.
  camera.mask.polygons = {{{157, 0}, {162, 0}, {162, 100}, {157, 100}}};

  const FrameObservation seen = seen_of({{-1.2, 0.8, 0.6}, p_RB, std::nullopt}, camera);

  ASSERT_EQ(seen.balls.size(), 1U);
  EXPECT_LT(error_of(seen.balls.front(), p_RB), 0.03);
}

TEST(PerceivedBall, SeesABallInTheAirOverTheCarpet) {
  const Point3<Robot> p_RB{0.9, 0.3, 0.4};

  const FrameObservation seen = seen_of({{-1.2, 0.8, 0.6}, p_RB, std::nullopt});

  ASSERT_EQ(seen.balls.size(), 1U);
  EXPECT_LT(error_of(seen.balls.front(), p_RB), 0.03);
  const BallRange& range = seen.ball_ranges.front();
  const double truth = (p_RB.vector() - seen.balls.front().ray_R.origin.vector()).norm();
  EXPECT_NEAR(range.by_size, truth, 2.0 * range.sigma_by_size);
  EXPECT_GT(range.on_floor, 1.4 * truth);
  EXPECT_GT(range.flying_log_odds, 1.0);
}

TEST(PerceivedBall, HasTwoWordsForTheRangeOfABallOnTheFloor) {
  const Point3<Robot> p_RB{1.2, -0.4, 0.11};

  const FrameObservation seen = seen_of({{-1.2, 0.8, 0.6}, p_RB, std::nullopt});

  ASSERT_EQ(seen.ball_ranges.size(), 1U);
  const BallRange& range = seen.ball_ranges.front();
  const double truth = (p_RB.vector() - seen.balls.front().ray_R.origin.vector()).norm();
  EXPECT_NEAR(range.on_floor, truth, 3.0 * range.sigma_on_floor);
  EXPECT_NEAR(range.by_size, truth, 3.0 * range.sigma_by_size);
  EXPECT_LT(range.flying_log_odds, 0.0);
}

}  // namespace
}  // namespace teamsight::vision
