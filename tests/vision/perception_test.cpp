// tests/vision/perception_test.cpp: frames that are none, and what a small painted picture shows.
#include "vision/perception.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/painted_frame.hpp"

namespace teamsight::vision {
namespace {

TEST(Perception, RejectsWhatIsNoFrameOfItsCamera) {
  Perception perception(small_camera(), test_field());
  const std::vector<std::uint8_t> bytes(2 * kWidth * kHeight);
  ImageView truncated = view_of(bytes);
  truncated.bytes = truncated.bytes.first(bytes.size() - 1);
  ImageView wide = view_of(bytes);
  wide.width_px = 2 * kWidth;
  ImageView other = view_of(bytes);
  other.format = PixelFormat::kUyvy;

  EXPECT_EQ(perception.see(truncated, {}).error(), FrameReject::kTruncated);
  EXPECT_EQ(perception.see(wide, {}).error(), FrameReject::kWrongSize);
  EXPECT_EQ(perception.see(other, {}).error(), FrameReject::kWrongFormat);
}

TEST(Perception, IsLostAndSeesNoBallInEmptyFrames) {
  Perception perception(small_camera(), test_field());
  for (const int level : {0, 90, 255}) {
    std::vector<std::uint8_t> bytes(2 * kWidth * kHeight, 128);
    for (std::size_t i = 0; i < bytes.size(); i += 2) bytes[i] = static_cast<std::uint8_t>(level);

    const auto seen = perception.see(view_of(bytes), {});

    ASSERT_TRUE(seen);
    EXPECT_EQ((*seen)->posture.status, PostureStatus::kLost);
    EXPECT_TRUE((*seen)->balls.empty());
    EXPECT_NE((*seen)->light, Light::kGood);
  }
}

TEST(Perception, IsLostInNoise) {
  Perception perception(small_camera(), test_field());
  std::mt19937 random(4);
  std::uniform_int_distribution<int> any(0, 255);
  std::vector<std::uint8_t> bytes(2 * kWidth * kHeight);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(any(random));

  const auto seen = perception.see(view_of(bytes), {});

  ASSERT_TRUE(seen);
  EXPECT_EQ((*seen)->posture.status, PostureStatus::kLost);
}

TEST(Perception, FindsThePostureInAPaintedFrame) {
  const Scene scene{{-1.2, 0.8, 0.6}, std::nullopt, std::nullopt};
  Perception perception(small_camera(), test_field());
  const auto bytes = frame_of(small_camera(), test_field(), scene);
  MotionPrior prior;
  prior.start_side = StartSide::kOwnHalf;

  const auto seen = perception.see(view_of(bytes), prior);

  ASSERT_TRUE(seen);
  const PostureEstimate& posture = (*seen)->posture;
  EXPECT_EQ(posture.status, PostureStatus::kOk);
  EXPECT_LT((posture.X_FR.origin().vector() - scene.X_FR.origin().vector()).norm(), 0.03);
  EXPECT_NEAR(angle_difference(posture.X_FR.theta(), scene.X_FR.theta()), 0.0, 0.02);
  EXPECT_EQ((*seen)->light, Light::kGood);
  EXPECT_TRUE((*seen)->balls.empty());
}

TEST(Perception, SeesByTheCubeWhatItSeesByDiscs) {
  CameraParameters camera = small_camera();
  camera.colours.samples.clear();
  camera.colours.method = ColourMethod::kCube;
  camera.colours.cube =
      CubeParameters{{{{1.0, 0.0, 0.0, 80.0}, {0.0, 1.0, 0.0, 80.0}, {0.0, 0.0, 1.0, 80.0}}},
                     {ColourClass::kBlack,
                      ColourClass::kRed,
                      ColourClass::kGreen,
                      ColourClass::kBall,
                      ColourClass::kBlue,
                      ColourClass::kMagenta,
                      ColourClass::kCyan,
                      ColourClass::kWhite}};
  const Point3<Robot> p_RB{1.5, -0.7, 0.11};

  const FrameObservation seen = seen_of({{-1.2, 0.8, 0.6}, p_RB, Point<Robot>{1.4, 1.0}}, camera);

  EXPECT_NE(seen.posture.status, PostureStatus::kLost);
  ASSERT_EQ(seen.balls.size(), 1U);
  EXPECT_LT(error_of(seen.balls.front(), p_RB), 0.02);
  EXPECT_EQ(seen.obstacles.size(), 1U);
}

TEST(Perception, SeesInALargePictureWhatASmallOneShows) {
  const CameraParameters camera = large_camera();
  const Point3<Robot> p_RB{1.5, -0.7, 0.11};
  const Point<Robot> p_RO{1.4, 1.0};
  const Scene scene{{-1.2, 0.8, 0.6}, p_RB, p_RO};
  Perception perception(camera, test_field());
  const auto bytes = frame_of(camera, test_field(), scene);
  MotionPrior prior;
  prior.start_side = StartSide::kOwnHalf;

  const auto seen = perception.see({bytes, 1280, 1024, PixelFormat::kYuyv}, prior);

  ASSERT_TRUE(seen);
  const FrameObservation& frame = **seen;
  EXPECT_EQ(frame.posture.status, PostureStatus::kOk);
  EXPECT_LT((frame.posture.X_FR.origin().vector() - scene.X_FR.origin().vector()).norm(), 0.01);
  EXPECT_NEAR(angle_difference(frame.posture.X_FR.theta(), scene.X_FR.theta()), 0.0, 0.01);
  ASSERT_EQ(frame.balls.size(), 1U);
  EXPECT_LT(error_of(frame.balls.front(), p_RB), 0.01);
  EXPECT_TRUE(frame.ball_pixels[0].on_carpet);
  ASSERT_EQ(frame.obstacles.size(), 1U);
  const Point<Robot>& foot = frame.obstacles.front().p_RO;
  EXPECT_NEAR(std::atan2(foot.y, foot.x), std::atan2(p_RO.y, p_RO.x), 0.03);
  EXPECT_NEAR(std::hypot(foot.x, foot.y), std::hypot(p_RO.x, p_RO.y) - 0.25, 0.06);
}

TEST(Perception, GivesTheSameAnswerTwice) {
  const Scene scene{{2.0, -1.0, -2.0}, Point3<Robot>{0.8, 0.5, 0.11}, std::nullopt};
  Perception perception(small_camera(), test_field());
  const auto bytes = frame_of(small_camera(), test_field(), scene);

  const auto first = perception.see(view_of(bytes), {});
  const FrameObservation before = **first;
  const auto second = perception.see(view_of(bytes), {});

  EXPECT_EQ(before.posture, (*second)->posture);
  EXPECT_EQ(before.balls, (*second)->balls);
}

}  // namespace
}  // namespace teamsight::vision
