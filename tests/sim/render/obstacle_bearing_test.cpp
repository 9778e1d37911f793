// tests/sim/render/obstacle_bearing_test.cpp: rendered robots that nothing hides are told where
// they are, and their covariance covers how far beside that they are told.
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/angle.hpp"
#include "settings/load.hpp"
#include "sim/render/renderer.hpp"
#include "tests/support/process.hpp"
#include "vision/perception.hpp"

namespace teamsight::sim {
namespace {

constexpr int kFrames = 60;
constexpr int kRobots = 4;          // a frame, a quarter turn apart: none hides another
constexpr double kSameTurn = 0.35;  // rad from a robot's azimuth to that of its sighting
const Pose<Field, Robot> kHere{-1.0, 0.5, 0.4};

/// Of the sightings of one eye; across the line of sight.
struct Across {
  int count{0};
  double sum{0.0};         // m
  double square{0.0};      // m^2
  double normalised{0.0};  // of the claimed variance
};

void add(const vision::FrameObservation& seen,
         const std::vector<Point<Robot>>& robots,
         Across& across) {
  for (const Point<Robot>& robot : robots) {
    const double azimuth = std::atan2(robot.y, robot.x);
    for (const ObstacleSighting& told : seen.obstacles) {
      const Eigen::Vector2d foot = told.p_RO.vector();
      const double turn = angle_difference(std::atan2(foot.y(), foot.x()), azimuth);
      if (std::abs(turn) > kSameTurn) continue;
      const Eigen::Vector2d aside = Eigen::Vector2d(-foot.y(), foot.x()).normalized();
      const double error = foot.norm() * turn;
      ++across.count;
      across.sum += error;
      across.square += error * error;
      across.normalised += error * error / aside.dot(told.cov_R * aside);
    }
  }
}

Across seen_by(const char* camera_file) {
  const FieldModel field =
      settings::load_field(test::source_path("config/fields/msl-2024.textproto"));
  const vision::CameraParameters camera = settings::load_camera(test::source_path(camera_file));
  Renderer renderer(camera, field, {});
  vision::Perception perception(camera, field);
  Random random{7};
  std::vector<std::uint8_t> bytes;
  Across across;
  for (int frame = 0; frame < kFrames; ++frame) {
    Scene scene;
    scene.X_FR = kHere;
    std::vector<Point<Robot>> robots;
    const double first = random.uniform(0.0, 1.5);
    for (int i = 0; i < kRobots; ++i) {
      const double azimuth = first + 1.57 * i;
      const double distance = random.uniform(0.8, 4.5);
      robots.push_back({distance * std::cos(azimuth), distance * std::sin(azimuth)});
      SceneRobot robot;
      robot.p_F = kHere * robots.back();
      if (i % 2 == 1) robot.shirt = {200, 30, 30};
      scene.robots.push_back(robot);
    }
    renderer.draw(scene, random, bytes);
    vision::MotionPrior prior;
    prior.X_FR = kHere;
    const auto seen =
        perception.see({bytes, camera.width_px, camera.height_px, camera.format}, prior);
    EXPECT_TRUE(seen);
    if (seen) add(**seen, robots, across);
  }
  return across;
}

// A round foot errs by what the lines of sight beside it leave open: 1 cm. More is claimed, for
// real robots are not round.
void expect_told_well(const char* camera_file) {
  const Across across = seen_by(camera_file);

  ASSERT_GT(across.count, kFrames * kRobots * 9 / 10) << camera_file;
  const double n = across.count;
  EXPECT_LT(std::abs(across.sum / n), 0.003) << camera_file;
  EXPECT_LT(std::sqrt(across.square / n), 0.02) << camera_file;
  EXPECT_LT(across.normalised / n, 1.3) << camera_file;
}

TEST(ObstacleBearing, OfRoundFeetIsUnbiasedAndBetterThanClaimed) {
  expect_told_well("config/cameras/sim-640.textproto");
  expect_told_well("config/cameras/sim-isometric.textproto");
}

}  // namespace
}  // namespace teamsight::sim
