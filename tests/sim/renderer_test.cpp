// tests/sim/renderer_test.cpp: pictures show the match where the camera file says it must be.
#include "sim/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "settings/load.hpp"
#include "tests/support/process.hpp"
#include "vision/perception.hpp"

namespace teamsight::sim {
namespace {

constexpr int kWidth = 640;
constexpr double kCentreU = 319.5;
constexpr double kCentreV = 239.5;

vision::CameraParameters sim_camera() {
  return settings::load_camera(test::source_path("config/cameras/sim-640.textproto"));
}

FieldModel one_line(const Point<Field>& from, const Point<Field>& to) {
  FieldModel field;
  field.length = 12.0;
  field.width = 8.0;
  field.surround = 1.0;
  field.line_width = 0.125;
  field.lines.push_back({"line", from, to, LineFamily::kOther});
  return field;
}

std::vector<std::uint8_t> picture_of(const FieldModel& field, const Scene& scene) {
  RenderParameters parameters;
  parameters.pixel_noise_sigma = 0.0;
  Renderer renderer(sim_camera(), field, parameters);
  std::mt19937 random(1);
  std::vector<std::uint8_t> picture;
  renderer.draw(scene, random, picture);
  return picture;
}

double luminance(const std::vector<std::uint8_t>& picture, int u, int v) {
  return picture[2 * static_cast<std::size_t>(v * kWidth + u)];
}

// A ball far outside, so that it is not in the picture.
Scene empty_scene() {
  return {{}, {}, {100.0, 0.0, 0.11}};
}

// 2.0273 m on the floor are 150 px in this camera's file.
constexpr double kLineDistance = 2.0273;
constexpr double kLineRadius = 150.0;

TEST(Renderer, ShowsALineAheadAboveTheCentre) {
  const auto picture =
      picture_of(one_line({kLineDistance, -3.0}, {kLineDistance, 3.0}), empty_scene());

  double sum = 0.0;
  double weighted = 0.0;
  for (int v = 60; v < 120; ++v) {
    const double paint = std::max(luminance(picture, 320, v) - 90.0, 0.0);
    sum += paint;
    weighted += paint * v;
  }
  ASSERT_GT(sum, 200.0);
  EXPECT_NEAR(weighted / sum, kCentreV - kLineRadius, 1.0);
}

TEST(Renderer, ShowsALineToTheLeftOnTheRightBecauseTheMirrorTurnsItRound) {
  const auto picture =
      picture_of(one_line({-3.0, kLineDistance}, {3.0, kLineDistance}), empty_scene());

  double sum = 0.0;
  double weighted = 0.0;
  for (int u = 440; u < 500; ++u) {
    const double paint = std::max(luminance(picture, u, 240) - 90.0, 0.0);
    sum += paint;
    weighted += paint * u;
  }
  ASSERT_GT(sum, 200.0);
  EXPECT_NEAR(weighted / sum, kCentreU + kLineRadius, 1.0);
}

// Where this camera shows the floor at a distance, or whatever is on the same line of sight.
double radius_px(double distance) {
  return std::atan(distance / 1.57) / 0.006079;
}

TEST(Renderer, ShowsTheBallBetweenTheLinesOfSightThatTouchIt) {
  // Seen from the viewpoint at 0.75 m, the middle at (1.2, 0, 0.11) is so far from straight down,
  // and the ball fills so much to both sides.
  const double middle = std::atan2(1.2, 0.64);
  const double half = std::asin(0.11 / std::hypot(1.2, 0.64));
  Scene scene = empty_scene();
  scene.p_FB = {1.2, 0.0, 0.11};
  FieldModel bare = one_line({}, {});
  bare.lines.clear();

  const auto picture = picture_of(bare, scene);

  int first = 480;
  int last = -1;
  for (int v = 0; v < 480; ++v) {
    if (luminance(picture, 320, v) == 139.0) {
      first = std::min(first, v);
      last = std::max(last, v);
    }
  }
  EXPECT_NEAR(first, kCentreV - radius_px(0.75 * std::tan(middle + half)), 1.0);
  EXPECT_NEAR(last, kCentreV - radius_px(0.75 * std::tan(middle - half)), 1.0);
}

TEST(Renderer, HidesWhatIsBehindARobot) {
  Scene scene = empty_scene();
  scene.p_FB = {3.0, 0.0, 0.11};
  scene.others = {{1.5, 0.0}};

  const auto picture = picture_of(one_line({-3.0, -3.0}, {3.0, -3.0}), scene);

  // Its foot is at 1.25 m, 110.6 px above the centre; from there outwards all is dark.
  const int foot = static_cast<int>(kCentreV - 110.6);
  EXPECT_GT(luminance(picture, 320, foot + 4), 60.0);
  for (int v = foot - 2; v > 20; --v) {
    EXPECT_EQ(luminance(picture, 320, v), 20.0) << "row " << v;
  }
}

TEST(Renderer, DrawsWhatPerceptionFindsAgain) {
  const auto field = settings::load_field(test::source_path("config/fields/msl-2024.textproto"));
  const vision::CameraParameters camera = sim_camera();
  Renderer renderer(camera, field, {});
  vision::Perception perception(camera, field);
  std::mt19937 random(5);
  std::vector<std::uint8_t> picture;

  for (const Pose<Field, Robot>& X_FR : {Pose<Field, Robot>(-3.0, 1.5, 0.4),
                                         Pose<Field, Robot>(-8.5, -2.0, -2.0),
                                         Pose<Field, Robot>(-1.0, -4.5, 1.2)}) {
    const Point<Field> p_FB = X_FR * Point<Robot>{1.5, 1.0};
    renderer.draw({X_FR, {}, {p_FB.x, p_FB.y, 0.11}}, random, picture);
    vision::MotionPrior prior;
    prior.start_side = vision::StartSide::kOwnHalf;
    const auto seen =
        perception.see({picture, camera.width_px, camera.height_px, camera.format}, prior);

    ASSERT_TRUE(seen.has_value());
    const PostureEstimate& posture = (*seen)->posture;
    ASSERT_NE(posture.status, PostureStatus::kLost);
    EXPECT_LT((posture.X_FR.origin().vector() - X_FR.origin().vector()).norm(), 0.05);
    EXPECT_LT(std::abs(angle_difference(posture.X_FR.theta(), X_FR.theta())), 0.03);
    ASSERT_FALSE((*seen)->balls.empty());
    const Eigen::Vector3d ray = (*seen)->balls.front().ray_R.direction;
    EXPECT_NEAR(std::atan2(ray.y(), ray.x()), std::atan2(1.0, 1.5), 0.02);
  }
}

}  // namespace
}  // namespace teamsight::sim
