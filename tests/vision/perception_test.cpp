// tests/vision/perception_test.cpp: frames that are none, and what a small painted picture shows.
#include "vision/perception.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/synthetic_points.hpp"

namespace teamsight::vision {
namespace {

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;

CameraParameters small_camera() {
  CameraParameters camera;
  camera.name = "small";
  camera.width_px = kWidth;
  camera.height_px = kHeight;
  camera.format = PixelFormat::kYuyv;
  camera.forward = 0.5 * std::numbers::pi;
  camera.mirrored = true;
  RadialTable table;
  table.centre_u_px = 159.5;
  table.centre_v_px = 119.5;
  table.mirror_height = 0.75;
  for (int radius = 15; radius <= 118; radius += 5) {
    table.rows.push_back({1.0 * radius, 1.57 * std::tan(0.0118 * radius), 0.1});
  }
  camera.mirror = table;
  camera.mask.inner_radius_px = 20.0;
  camera.scan.max_distance = 6.0;
  camera.colours.white_min_y = 150;
  camera.colours.black_max_y = 40;
  camera.colours.samples = {{ColourClass::kGreen, 101, 94, 24}, {ColourClass::kBall, 61, 200, 30}};
  return camera;
}

// The same eye with a sensor of more pixels.
CameraParameters large_camera() {
  constexpr double kScale = 4.0;
  CameraParameters camera = small_camera();
  camera.width_px = 1280;
  camera.height_px = 1024;
  auto& table = std::get<RadialTable>(camera.mirror);
  table.centre_u_px = 639.5;
  table.centre_v_px = 511.5;
  for (RingMark& row : table.rows) row.radius_px *= kScale;
  camera.mask.inner_radius_px *= kScale;
  return camera;
}

struct Paint {
  int y{0};
  int u{128};
  int v{128};
};

constexpr Paint kGreen{87, 101, 94};
constexpr Paint kWhite{230, 128, 128};
constexpr Paint kOrange{139, 61, 200};
constexpr Paint kBlack{20, 128, 128};

/// What stands on the field besides the paint.
struct Scene {
  Pose<Field, Robot> X_FR;
  std::optional<Point3<Robot>> ball;   // of 0.11 m
  std::optional<Point<Robot>> pillar;  // black, radius 0.25 m
};

Paint look(const Ray<Robot>& ray, const FieldModel& field, const Scene& scene) {
  if (scene.ball) {
    const Eigen::Vector3d to_ball = scene.ball->vector() - ray.origin.vector();
    const double along = to_ball.dot(ray.direction);
    if (along > 0.0 && (to_ball - along * ray.direction).norm() < 0.11) return kOrange;
  }
  const auto floor = meet_plane(ray, 0.0);
  if (scene.pillar) {
    // Hidden behind or inside the pillar: the way to the floor passes over its disc.
    const Eigen::Vector2d p = scene.pillar->vector();
    const Eigen::Vector2d away = ray.direction.head<2>().normalized();
    const double along = p.dot(away);
    const double reach = floor ? floor->vector().norm() : 1e9;
    if (along > 0.0 && (p - along * away).norm() < 0.25 && reach > p.norm() - 0.25) return kBlack;
  }
  if (!floor) return kBlack;
  const Point<Field> p_F = scene.X_FR * *floor;
  if (!is_on_carpet(field, p_F)) return kBlack;
  const auto line = nearest_line(field, p_F);
  return line && std::abs(line->distance) < 0.5 * field.line_width ? kWhite : kGreen;
}

Paint look(const CameraModel& model, const FieldModel& field, const Scene& scene, Pixel pixel) {
  const auto ray = model.ray(pixel);
  return ray ? look(*ray, field, scene) : kBlack;
}

// The mean of nine rays through a pixel: edges must be grey to be found well.
Paint pixel_of(const CameraModel& model, const FieldModel& field, const Scene& scene, Pixel pixel) {
  Paint sum{0, 0, 0};
  for (const double du : {-1.0 / 3.0, 0.0, 1.0 / 3.0}) {
    for (const double dv : {-1.0 / 3.0, 0.0, 1.0 / 3.0}) {
      const Paint paint = look(model, field, scene, {pixel.u + du, pixel.v + dv});
      sum = {sum.y + paint.y, sum.u + paint.u, sum.v + paint.v};
    }
  }
  return {sum.y / 9, sum.u / 9, sum.v / 9};
}

std::vector<std::uint8_t> frame_of(const CameraParameters& camera,
                                   const FieldModel& field,
                                   const Scene& scene) {
  const CameraModel model(camera);
  const bool is_small = camera.width_px == kWidth;  // of many pixels one ray each is enough
  std::vector<std::uint8_t> bytes;
  for (std::uint32_t v = 0; v < camera.height_px; ++v) {
    for (std::uint32_t u = 0; u < camera.width_px; ++u) {
      const Pixel pixel{1.0 * u, 1.0 * v};
      const Paint paint =
          is_small ? pixel_of(model, field, scene, pixel) : look(model, field, scene, pixel);
      bytes.push_back(static_cast<std::uint8_t>(paint.y));
      bytes.push_back(static_cast<std::uint8_t>(u % 2 == 0 ? paint.u : paint.v));
    }
  }
  return bytes;
}

ImageView view_of(const std::vector<std::uint8_t>& bytes) {
  return {bytes, kWidth, kHeight, PixelFormat::kYuyv};
}

// What a robot with this camera sees of the scene.
FrameObservation seen_of(const Scene& scene, const CameraParameters& camera = small_camera()) {
  Perception perception(camera, test_field());
  const auto bytes = frame_of(camera, test_field(), scene);
  const auto seen = perception.see(view_of(bytes), {});
  return seen ? **seen : FrameObservation{};
}

// Between the ball's ray and the way to its middle; rad.
double error_of(const BallRay& ball, const Point3<Robot>& p_RB) {
  const Eigen::Vector3d way = p_RB.vector() - ball.ray_R.origin.vector();
  return std::acos(ball.ray_R.direction.dot(way.normalized()));
}

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

TEST(Perception, PointsItsRayAtTheBall) {
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

TEST(Perception, KnowsWhatMakesABallOnTheCarpetOne) {
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

TEST(Perception, TakesBothSidesOfAMaskedStrutForOneBall) {
  const Point3<Robot> p_RB{0.7, 0.0, 0.11};
  CameraParameters camera = small_camera();
  // Forward is up in the picture: a strut of five pixels over the middle of the ball.
  camera.mask.polygons = {{{157, 0}, {162, 0}, {162, 100}, {157, 100}}};

  const FrameObservation seen = seen_of({{-1.2, 0.8, 0.6}, p_RB, std::nullopt}, camera);

  ASSERT_EQ(seen.balls.size(), 1U);
  EXPECT_LT(error_of(seen.balls.front(), p_RB), 0.03);
}

TEST(Perception, SeesABallInTheAirOverTheCarpet) {
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

TEST(Perception, HasTwoWordsForTheRangeOfABallOnTheFloor) {
  const Point3<Robot> p_RB{1.2, -0.4, 0.11};

  const FrameObservation seen = seen_of({{-1.2, 0.8, 0.6}, p_RB, std::nullopt});

  ASSERT_EQ(seen.ball_ranges.size(), 1U);
  const BallRange& range = seen.ball_ranges.front();
  const double truth = (p_RB.vector() - seen.balls.front().ray_R.origin.vector()).norm();
  EXPECT_NEAR(range.on_floor, truth, 3.0 * range.sigma_on_floor);
  EXPECT_NEAR(range.by_size, truth, 3.0 * range.sigma_by_size);
  EXPECT_LT(range.flying_log_odds, 0.0);
}

TEST(Perception, FindsTheFootOfAnObstacle) {
  const Point<Robot> p_RO{1.4, 1.0};
  const Scene scene{{-1.2, 0.8, 0.6}, std::nullopt, p_RO};
  Perception perception(small_camera(), test_field());
  const auto bytes = frame_of(small_camera(), test_field(), scene);

  const auto seen = perception.see(view_of(bytes), {});

  ASSERT_TRUE(seen);
  ASSERT_GE((*seen)->obstacles.size(), 1U);
  const ObstacleSighting& obstacle = (*seen)->obstacles.front();
  const double range = std::hypot(p_RO.x, p_RO.y);
  EXPECT_NEAR(std::atan2(obstacle.p_RO.y, obstacle.p_RO.x), std::atan2(p_RO.y, p_RO.x), 0.05);
  EXPECT_NEAR(std::hypot(obstacle.p_RO.x, obstacle.p_RO.y), range - 0.25, 0.12);
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
