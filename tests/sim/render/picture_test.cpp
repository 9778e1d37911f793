// tests/sim/render/picture_test.cpp: pictures show the match where the camera file says it must be.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "settings/load.hpp"
#include "sim/render/renderer.hpp"
#include "sim/show.hpp"
#include "tests/support/process.hpp"
#include "vision/perception.hpp"
#include "vision/pixel_reader.hpp"

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

// No noise, no blur, even light.
PictureParameters plain() {
  PictureParameters parameters;
  parameters.sensor.noise_sigma = 0.0;
  parameters.sensor.dark_noise_sigma = 0.0;
  parameters.sensor.defocus_px = 0.0;
  parameters.sensor.rim_defocus_px = 0.0;
  parameters.sensor.vignetting = 0.0;
  parameters.unevenness = 0.0;
  return parameters;
}

std::vector<std::uint8_t> picture_of(const FieldModel& field,
                                     const Scene& scene,
                                     const PictureParameters& parameters = plain()) {
  Renderer renderer(sim_camera(), field, parameters);
  Random random(1);
  std::vector<std::uint8_t> picture;
  renderer.draw(scene, random, picture);
  return picture;
}

double luminance(const std::vector<std::uint8_t>& picture, int u, int v) {
  return picture[2 * static_cast<std::size_t>(v * kWidth + u)];
}

// Orange has much red in its chroma, carpet, paint and shadow have not.
bool is_ball(const std::vector<std::uint8_t>& picture, int u, int v, int least = 145) {
  return picture[2 * static_cast<std::size_t>(v * kWidth + u / 2 * 2) + 3] > least;
}

SceneBall ball_at(double x, double y, double z) {
  return {{x, y, z}, {}, 0.11, {}};
}

// 2.0273 m on the floor are 150 px in this camera's file.
constexpr double kLineDistance = 2.0273;
constexpr double kLineRadius = 150.0;

TEST(Renderer, ShowsALineAheadAboveTheCentre) {
  const auto picture = picture_of(one_line({kLineDistance, -3.0}, {kLineDistance, 3.0}), Scene{});

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
  const auto picture = picture_of(one_line({-3.0, kLineDistance}, {3.0, kLineDistance}), Scene{});

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
  Scene scene = Scene{};
  scene.balls = {ball_at(1.2, 0.0, 0.11)};
  FieldModel bare = one_line({}, {});
  bare.lines.clear();

  const auto picture = picture_of(bare, scene);

  int first = 480;
  int last = -1;
  for (int v = 0; v < 480; ++v) {
    if (is_ball(picture, 320, v)) {
      first = std::min(first, v);
      last = std::max(last, v);
    }
  }
  EXPECT_NEAR(first, kCentreV - radius_px(0.75 * std::tan(middle + half)), 1.0);
  EXPECT_NEAR(last, kCentreV - radius_px(0.75 * std::tan(middle - half)), 1.0);
}

TEST(Renderer, HidesWhatIsBehindARobot) {
  Scene scene;
  scene.balls = {ball_at(3.0, 0.0, 0.11)};
  scene.robots = {{{1.5, 0.0}, {}, 0.25, 0.8, {20, 20, 20}}};

  const auto picture = picture_of(one_line({-3.0, -3.0}, {3.0, -3.0}), scene);

  // Its foot is at 1.25 m, 110.6 px above the centre; from there outwards all is dark, but for the
  // lid of its base.
  const int foot = static_cast<int>(kCentreV - 110.6);
  EXPECT_GT(luminance(picture, 320, foot + 40), 60.0);
  for (int v = foot - 4; v > 20; --v) {
    EXPECT_LT(luminance(picture, 320, v), 100.0) << "row " << v;
  }
  EXPECT_LT(luminance(picture, 320, foot - 20), 30.0);
}

TEST(Picture, EyesThatShareAFloorSeeTheSame) {
  const FieldModel field = one_line({kLineDistance, -3.0}, {kLineDistance, 3.0});
  PictureParameters uneven = plain();
  uneven.unevenness = 0.1;
  const auto alone = picture_of(field, {}, uneven);
  const Renderer first(sim_camera(), field, uneven);
  Renderer second(sim_camera(), field, uneven, first.floor());
  Random random(1);
  std::vector<std::uint8_t> picture;
  second.draw({}, random, picture);

  EXPECT_EQ(second.floor(), first.floor());
  EXPECT_EQ(picture, alone);
  EXPECT_NE(picture, picture_of(field, {}, plain()));  // the floor's light is in it
}

// The coarse picture with its smooth edges is nearly the mean of many samples.
TEST(Renderer, DrawsNearlyTheSameWithOneSampleAsWithMany) {
  const auto field = settings::load_field(test::source_path("config/fields/msl-2024.textproto"));
  Scene scene;
  scene.X_FR = {-3.0, 1.5, 0.4};
  scene.balls = {ball_at(-2.0, 1.0, 0.11), ball_at(-4.0, 3.0, 0.6)};
  scene.robots = {{{-1.5, 2.5}, {}, 0.25, 0.8, {40, 190, 210}}};
  PictureParameters many = plain();
  many.fineness = 4;

  const auto coarse = picture_of(field, scene);
  const auto fine = picture_of(field, scene, many);

  double squares = 0.0;
  for (std::size_t i = 0; i < coarse.size(); i += 2) {
    squares += std::pow(static_cast<double>(coarse[i]) - static_cast<double>(fine[i]), 2);
  }
  EXPECT_LT(std::sqrt(squares / (static_cast<double>(coarse.size()) / 2.0)), 4.0);
}

TEST(Renderer, SmearsWhatPassesDuringTheExposure) {
  const FieldModel field = one_line({kLineDistance, -3.0}, {kLineDistance, 3.0});
  Scene turning;
  turning.omega = 5.0;
  PictureParameters slow = plain();
  slow.exposure = 0.02;
  slow.moments = 8;
  turning.balls = {ball_at(1.2, 0.0, 0.11)};

  const auto sharp = picture_of(field, turning);
  const auto smeared = picture_of(field, turning, slow);

  // 0.1 rad at 105 px: the ball's disc grows by some 10 px sideways.
  const auto width = [](const std::vector<std::uint8_t>& picture) {
    int count = 0;
    for (int u = 240; u < 400; ++u) {
      count += is_ball(picture, u, 132, 105) ? 1 : 0;
    }
    return count;
  };
  EXPECT_GT(width(smeared), width(sharp) + 5);
}

TEST(Renderer, AddsTheNoiseThatItIsAskedFor) {
  PictureParameters noisy = plain();
  noisy.sensor.noise_sigma = 4.0;
  FieldModel bare = one_line({}, {});
  bare.lines.clear();

  const auto picture = picture_of(bare, {}, noisy);

  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (int v = 140; v < 180; ++v) {
    for (int u = 280; u < 360; ++u, ++count) {
      sum += luminance(picture, u, v);
      squares += std::pow(luminance(picture, u, v), 2);
    }
  }
  const double mean = sum / count;
  // Of luminance: the root of 0.299^2 + 0.587^2 + 0.114^2, times 4.
  EXPECT_NEAR(std::sqrt(squares / count - mean * mean), 0.669 * 4.0, 0.2);
}

TEST(Renderer, DrawsWhatPerceptionFindsAgain) {
  const auto field = settings::load_field(test::source_path("config/fields/msl-2024.textproto"));
  const vision::CameraParameters camera = sim_camera();
  PictureParameters look;
  look.body = low_body();
  Renderer renderer(camera, field, look);
  vision::Perception perception(camera, field);
  Random random(5);
  std::vector<std::uint8_t> picture;

  for (const Pose<Field, Robot>& X_FR : {Pose<Field, Robot>(-3.0, 1.5, 0.4),
                                         Pose<Field, Robot>(-8.5, -2.0, -2.0),
                                         Pose<Field, Robot>(-1.0, -4.5, 1.2)}) {
    const Point<Field> p_FB = X_FR * Point<Robot>{1.5, 1.0};
    Scene scene;
    scene.X_FR = X_FR;
    scene.balls = {ball_at(p_FB.x, p_FB.y, 0.11)};
    renderer.draw(scene, random, picture);
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

// Its sides and underside are darker than its top, and are ball as well: the middle of the top
// alone lies beyond the ball, by 4 % at 2 m and 6 % at 4 m.
TEST(Renderer, DrawsABallThatPerceptionFindsAsFarAwayAsItLies) {
  const auto field = settings::load_field(test::source_path("config/fields/msl-2024.textproto"));
  const vision::CameraParameters camera = sim_camera();
  PictureParameters look;
  look.body = low_body();
  Renderer renderer(camera, field, look);
  vision::Perception perception(camera, field);
  Random random(6);
  std::vector<std::uint8_t> picture;

  for (const double distance : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    Scene scene;
    scene.X_FR = {-5.0, 1.3, 0.0};
    scene.balls = {ball_at(-5.0 + distance, 1.3, 0.11)};
    renderer.draw(scene, random, picture);
    const auto seen =
        perception.see({picture, camera.width_px, camera.height_px, camera.format}, {});

    ASSERT_TRUE(seen.has_value());
    ASSERT_FALSE((*seen)->balls.empty()) << distance;
    const auto foot = vision::meet_plane((*seen)->balls.front().ray_R, 0.11);
    ASSERT_TRUE(foot.has_value());
    EXPECT_NEAR(std::hypot(foot->x, foot->y), distance, 0.035 * distance);
  }
}

// The chroma of a mosaic is blurred over three pixels, that of NV12 is shared by four.
TEST(Renderer, DrawsTheSameColoursInEveryFormat) {
  using vision::PixelFormat;
  const FieldModel field = one_line({0.0, -4.0}, {0.0, 4.0});
  Scene scene;
  scene.X_FR = {-2.0, 0.0, 0.0};
  scene.balls = {ball_at(-0.8, 0.3, 0.11)};
  vision::CameraParameters camera = sim_camera();
  const auto picture_in = [&](PixelFormat format) {
    camera.format = format;
    Renderer renderer(camera, field, plain());
    Random random(1);
    std::vector<std::uint8_t> picture;
    renderer.draw(scene, random, picture);
    return picture;
  };
  const auto expected_bytes = picture_in(PixelFormat::kBgr);
  const vision::PixelReader expected(
      {expected_bytes, camera.width_px, camera.height_px, PixelFormat::kBgr});

  for (const PixelFormat format : {PixelFormat::kNv12,
                                   PixelFormat::kBayerRggb,
                                   PixelFormat::kBayerBggr,
                                   PixelFormat::kBayerGrbg,
                                   PixelFormat::kBayerGbrg}) {
    const auto bytes = picture_in(format);
    const vision::PixelReader pixels({bytes, camera.width_px, camera.height_px, format});
    double luminance_sum = 0.0;
    double chroma_sum = 0.0;
    const std::size_t count = std::size_t{camera.width_px} * camera.height_px;
    for (std::size_t i = 0; i < count; ++i) {
      luminance_sum += std::abs(pixels.luminance(i) - expected.luminance(i));
      chroma_sum += std::abs(pixels.chroma(i).u - expected.chroma(i).u) +
                    std::abs(pixels.chroma(i).v - expected.chroma(i).v);
    }
    // A wrong mosaic is wrong by tens: carpet is three times as green as red or blue.
    EXPECT_LT(luminance_sum / static_cast<double>(count), 2.0);
    EXPECT_LT(chroma_sum / static_cast<double>(count), 2.0);
  }
}

}  // namespace
}  // namespace teamsight::sim
