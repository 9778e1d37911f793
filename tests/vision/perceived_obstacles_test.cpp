// tests/vision/perceived_obstacles_test.cpp: obstacles in small painted pictures.
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/painted_frame.hpp"

namespace teamsight::vision {
namespace {

TEST(PerceivedObstacle, FindsTheFootOfAnObstacle) {
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

constexpr Paint kCyan{147, 163, 51};
constexpr Paint kMagenta{110, 168, 207};

// How probably a pillar in this shirt is a team mate, says an eye that knows what the teams wear.
double likelihood_in(Paint shirt, const TeamShirts& shirts) {
  CameraParameters camera = small_camera();
  camera.colours.samples.push_back({ColourClass::kCyan, 163, 51, 30});
  camera.colours.samples.push_back({ColourClass::kMagenta, 168, 207, 25});
  PerceptionParameters parameters;
  parameters.shirts = shirts;
  Perception perception(camera, test_field(), parameters);
  const Scene scene{{-1.2, 0.8, 0.6}, std::nullopt, Point<Robot>{1.4, 1.0}, shirt, {}};
  const auto bytes = frame_of(camera, test_field(), scene);
  const auto seen = perception.see(view_of(bytes), {});
  return seen && (*seen)->obstacles.size() == 1 ? (*seen)->obstacles[0].teammate_likelihood : -1.0;
}

TEST(PerceivedObstacle, TellsATeamMateByItsShirt) {
  const TeamShirts both{ColourClass::kCyan, ColourClass::kMagenta};
  const TeamShirts own_only{ColourClass::kCyan, ColourClass::kNone};

  EXPECT_GT(likelihood_in(kCyan, both), 0.8);
  EXPECT_LT(likelihood_in(kMagenta, both), 0.2);
  EXPECT_GT(likelihood_in(kCyan, own_only), 0.8);
  EXPECT_LT(likelihood_in(kMagenta, own_only), 0.2);
}

TEST(PerceivedObstacle, KnowsOnlyTheOthersWhereTheOwnShirtIsNotGiven) {
  const TeamShirts theirs_only{ColourClass::kNone, ColourClass::kMagenta};

  EXPECT_LT(likelihood_in(kMagenta, theirs_only), 0.2);
  EXPECT_EQ(likelihood_in(kCyan, theirs_only), 0.5);
  EXPECT_EQ(likelihood_in(kBlack, theirs_only), 0.5);
}

TEST(PerceivedObstacle, HasNoEvidenceWithoutShirtsOrWordOfThem) {
  EXPECT_EQ(likelihood_in(kBlack, {ColourClass::kCyan, ColourClass::kMagenta}), 0.5);
  EXPECT_EQ(likelihood_in(kCyan, {}), 0.5);
}

// What a large picture shows of thin legs, each on two lines of sight.
std::vector<ObstaclePixels> things_at(const std::vector<Point<Robot>>& legs) {
  Scene scene{{-1.2, 0.8, 0.6}, std::nullopt, std::nullopt};
  scene.pillars = legs;
  scene.pillars_radius = 0.022;
  Perception perception(large_camera(), test_field());
  const auto bytes = frame_of(large_camera(), test_field(), scene);
  const auto seen = perception.see({bytes, 1280, 1024, PixelFormat::kYuyv}, {});
  return seen ? (*seen)->obstacle_pixels : std::vector<ObstaclePixels>{};
}

TEST(PerceivedObstacle, TakesThinPartsWithinAStrideForOnePersonsLegs) {
  const Point<Robot> left{1.5, 0.3};
  const Point<Robot> right{1.65, 0.05};

  const auto both = things_at({left, right});

  ASSERT_EQ(both.size(), 1U);
  EXPECT_EQ(both[0].kind, ObstacleKind::kLegs);
  EXPECT_TRUE(things_at({left}).empty());
  EXPECT_TRUE(things_at({left, {-1.5, 0.05}}).empty());
}

TEST(PerceivedObstacle, SaysTheNearestSixteenObstaclesAndHowManyMoreThereAre) {
  Scene scene{{-1.2, 0.8, 0.6}, std::nullopt, std::nullopt};
  for (int i = 0; i < 18; ++i) {
    const double turn = 2.0 * std::numbers::pi * (i + 0.5) / 18;
    const double distance = i == 4 || i == 11 ? 2.4 : 2.1;
    scene.pillars.push_back({distance * std::cos(turn), distance * std::sin(turn)});
  }
  Perception perception(large_camera(), test_field());
  const auto bytes = frame_of(large_camera(), test_field(), scene);

  const auto seen = perception.see({bytes, 1280, 1024, PixelFormat::kYuyv}, {});

  ASSERT_TRUE(seen);
  ASSERT_EQ((*seen)->obstacles.size(), kMaxObstacleSightings);
  EXPECT_EQ((*seen)->obstacles_left_out, 2U);
  for (const ObstacleSighting& obstacle : (*seen)->obstacles) {
    EXPECT_LT(obstacle.p_RO.vector().norm(), 2.05);
  }
}

}  // namespace
}  // namespace teamsight::vision
