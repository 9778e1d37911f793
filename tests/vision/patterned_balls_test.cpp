// tests/vision/patterned_balls_test.cpp: balls of several colours in small painted pictures, and
// what must not be taken for one.
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/vision/painted_frame.hpp"

namespace teamsight::vision {
namespace {

const Pose<Field, Robot> kHere{-1.2, 0.8, 0.6};

CameraParameters pattern_camera() {
  CameraParameters camera = small_camera();
  camera.colours.pattern = {ColourClass::kWhite, ColourClass::kBlack};
  return camera;
}

Scene scene_with(const Point3<Robot>& p_RB, double turn = 0.4) {
  Scene scene;
  scene.X_FR = kHere;
  scene.ball = p_RB;
  scene.ball_paint = {
      kWhite, kBlack, Eigen::AngleAxisd(turn, Eigen::Vector3d(0.5, -0.7, 0.6).normalized())};
  return scene;
}

Point3<Robot> ball_at(const Point<Robot>& p_R) {
  return {p_R.x, p_R.y, 0.11};
}

// A place on the field, from the robot of `kHere`.
Point3<Robot> ball_on(const Point<Field>& p_F) {
  return ball_at(kHere.inverse() * p_F);
}

// What was taken for balls, and why.
std::string balls_in(const FrameObservation& seen) {
  std::string words;
  for (const BallPixels& ball : seen.ball_pixels) {
    words += std::to_string(ball.u_px) + ", " + std::to_string(ball.v_px) + ":";
    for (const double trait : ball.pattern) words += " " + std::to_string(trait);
    words += "\n";
  }
  return words;
}

// What was taken for obstacles.
std::string obstacles_in(const FrameObservation& seen) {
  std::string words;
  for (std::size_t i = 0; i < seen.obstacles.size(); ++i) {
    const Point<Robot>& place = seen.obstacles[i].p_RO;
    words += seen.obstacle_pixels[i].kind == ObstacleKind::kRobot ? "robot" : "legs";
    words += " " + std::to_string(place.x) + ", " + std::to_string(place.y) + " of " +
             std::to_string(seen.obstacles[i].width) + "\n";
  }
  return words;
}

void expect_one(const FrameObservation& seen, const Point3<Robot>& p_RB) {
  ASSERT_EQ(seen.balls.size(), 1U);
  const BallRay& ball = seen.balls.front();
  EXPECT_EQ(ball.colour, BallColour::kPatterned);
  EXPECT_LT(error_of(ball, p_RB), 0.025);
  const double distance = (p_RB.vector() - ball.ray_R.origin.vector()).norm();
  EXPECT_NEAR(ball.angular_radius, std::asin(0.11 / distance), 0.3 * 0.11 / distance);
  EXPECT_GT(ball.confidence, 0.5);
}

// Distance from the robot, and turn about an axis that is none of the pattern's.
class PatternedBall : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(PatternedBall, IsSeenAloneOnTheCarpet) {
  const auto [distance, turn] = GetParam();
  const Point3<Robot> p_RB{distance * std::cos(-0.45), distance * std::sin(-0.45), 0.11};

  const FrameObservation seen = seen_of(scene_with(p_RB, turn), pattern_camera());

  expect_one(seen, p_RB);
  EXPECT_EQ(seen.ball_ranges.size(), 1U);
  EXPECT_TRUE(seen.ball_pixels[0].on_carpet);
  EXPECT_EQ(obstacles_in(seen), "");
}

INSTANTIATE_TEST_SUITE_P(AtDistanceTurnedBy,
                         PatternedBall,
                         testing::Combine(testing::Values(0.6, 1.0, 1.6, 2.2),
                                          testing::Values(0.0, 0.7, 1.4, 2.1, 2.8)));

TEST(PatternedBalls, OnALineIsSeen) {
  const Point3<Robot> p_RB = ball_on({0.0, 2.5});

  expect_one(seen_of(scene_with(p_RB), pattern_camera()), p_RB);
}

TEST(PatternedBalls, BesideARobotIsSeen) {
  const Point3<Robot> p_RB{1.3, -0.5, 0.11};
  Scene scene = scene_with(p_RB);
  scene.pillars = {{1.3 + 0.14, -0.5 + 0.37}};  // at its flank, 4 cm of carpet between them

  expect_one(seen_of(scene, pattern_camera()), p_RB);
}

TEST(PatternedBalls, OfWhiteAndOrangeIsOneBallAndPatterned) {
  const Point3<Robot> p_RB{1.1, -0.6, 0.11};
  Scene scene = scene_with(p_RB);
  scene.ball_paint.second = kOrange;
  CameraParameters camera = small_camera();
  camera.colours.pattern = {ColourClass::kWhite, ColourClass::kBall};

  expect_one(seen_of(scene, camera), p_RB);
}

TEST(PatternedBalls, LeavesABallOfOneColourWhatItIs) {
  Scene scene = scene_with({1.1, -0.6, 0.11});
  scene.ball_paint = {};

  const FrameObservation seen = seen_of(scene, pattern_camera());

  ASSERT_EQ(seen.balls.size(), 1U);
  EXPECT_EQ(seen.balls[0].colour, BallColour::kOrange);
  EXPECT_EQ(obstacles_in(seen), "");
}

TEST(PatternedBalls, OfOneOfTheColoursAloneIsNone) {
  for (const Paint paint : {kWhite, kBlack}) {
    Scene scene = scene_with({1.1, -0.6, 0.11});
    scene.ball_paint.first = scene.ball_paint.second = paint;

    EXPECT_EQ(balls_in(seen_of(scene, pattern_camera())), "");
  }
}

TEST(PatternedBalls, IsNotLookedForUnlessTheCameraFileSaysSo) {
  EXPECT_EQ(balls_in(seen_of(scene_with({1.1, -0.6, 0.11}))), "");
}

// From all over one half lines, their crossings, corners and ends are seen from everywhere; half a
// turn takes the other half to it.
TEST(PatternedBalls, AreNotInventedFromTheFieldsPaint) {
  ASSERT_TRUE(is_half_turn_symmetric(test_field()));
  for (const double x : {-4.0, -3.0, -2.0, -1.0, 0.0}) {
    for (const double y : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
      const FrameObservation seen =
          seen_of({{x, y, 0.3 * x + y}, std::nullopt, std::nullopt}, pattern_camera());

      EXPECT_EQ(balls_in(seen), "") << x << ' ' << y;
    }
  }
}

// Dark feet on and beside lines, with white patches of a ball's size.
TEST(PatternedBalls, AreNotInventedFromRobotsWithWhiteMarkers) {
  for (int i = 0; i < 12; ++i) {
    const double distance = 0.6 + 0.2 * i;
    // Every distance in three directions, neighbouring distances in the three others.
    for (int azimuth = i % 2; azimuth < 6; azimuth += 2) {
      Scene scene;
      scene.X_FR = kHere;
      scene.pillar = {distance * std::cos(azimuth), distance * std::sin(azimuth)};
      scene.shirt = kWhite;
      scene.marker = kWhite;

      EXPECT_EQ(balls_in(seen_of(scene, pattern_camera())), "") << distance << ' ' << azimuth;
    }
  }
}

TEST(PatternedBalls, AreNotInventedFromNoise) {
  std::mt19937 random(7);
  Perception perception(pattern_camera(), test_field());
  for (int i = 0; i < 20; ++i) {
    std::vector<std::uint8_t> bytes(std::size_t{kWidth} * kHeight * 2);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());

    EXPECT_EQ(balls_in(**perception.see(view_of(bytes), {})), "");
  }
}

}  // namespace
}  // namespace teamsight::vision
