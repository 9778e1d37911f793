// tests/sim/render/balls_and_obstacles_test.cpp: a ball alone on the carpet in rendered frames
// is neither a robot nor somebody's legs.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "settings/load.hpp"
#include "sim/render/renderer.hpp"
#include "tests/support/process.hpp"
#include "vision/perception.hpp"

namespace teamsight::sim {
namespace {

constexpr Paint kWhite{230, 230, 230};
constexpr Paint kBlack{20, 20, 20};
const Pose<Field, Robot> kHere{-3.0, 1.0, 0.4};

vision::CameraParameters camera_with(const std::vector<vision::ColourClass>& pattern) {
  vision::CameraParameters camera =
      settings::load_camera(test::source_path("config/cameras/sim-640.textproto"));
  camera.colours.pattern = pattern;
  return camera;
}

class BallEye {
 public:
  explicit BallEye(const std::vector<vision::ColourClass>& pattern)
      : camera_(camera_with(pattern)),
        renderer_(camera_, field_, {}),
        perception_(camera_, field_) {}

  // What is taken for obstacles.
  std::string obstacles_at(const Point<Robot>& p_RB, const BallLook& look) {
    Scene scene;
    scene.balls.push_back(ball_at(p_RB, look));
    std::string words;
    for (const ObstacleSighting& obstacle : see(scene).obstacles) {
      words += std::to_string(obstacle.p_RO.x) + ", " + std::to_string(obstacle.p_RO.y) + "; ";
    }
    return words;
  }

  // Whether a ball is seen, and no other, that touches a robot right behind it.
  bool sees_before_a_robot(double distance,
                           double azimuth,
                           const BallLook& look,
                           bool has_markers) {
    const Eigen::Vector2d way(std::cos(azimuth), std::sin(azimuth));
    const Point<Robot> place = Point<Robot>::from(distance * way);
    Scene scene;
    scene.balls.push_back(ball_at(place, look));
    SceneRobot robot;
    robot.p_F = kHere * Point<Robot>::from((distance + robot.radius + scene.balls[0].radius) * way);
    if (has_markers) robot.markers = kWhite;
    scene.robots.push_back(robot);
    const vision::FrameObservation seen = see(scene);
    if (seen.balls.size() != 1) return false;
    const Ray<Robot>& ray = seen.balls[0].ray_R;
    const Eigen::Vector3d middle(place.x, place.y, scene.balls[0].radius);
    return (middle - ray.origin.vector()).cross(ray.direction).norm() < 0.05;
  }

 private:
  static SceneBall ball_at(const Point<Robot>& p_RB, const BallLook& look) {
    const Point<Field> p_F = kHere * p_RB;
    SceneBall ball;
    ball.p_FB = {p_F.x, p_F.y, ball.radius};
    ball.look = look;
    return ball;
  }

  vision::FrameObservation see(Scene& scene) {
    scene.X_FR = kHere;
    renderer_.draw(scene, random_, bytes_);
    vision::MotionPrior prior;
    prior.X_FR = kHere;
    const auto seen =
        perception_.see({bytes_, camera_.width_px, camera_.height_px, camera_.format}, prior);
    EXPECT_TRUE(seen);
    return seen ? **seen : vision::FrameObservation{};
  }

  FieldModel field_ = settings::load_field(test::source_path("config/fields/msl-2024.textproto"));
  vision::CameraParameters camera_;
  Renderer renderer_;
  vision::Perception perception_;
  Random random_{5};
  std::vector<std::uint8_t> bytes_;
};

void expect_no_obstacles(BallEye& eye, const BallLook& ball) {
  for (int i = 0; i < 45; ++i) {
    const double distance = 0.5 + 0.1 * i;
    for (const double azimuth : {0.3, 2.4, 4.5}) {
      BallLook turned = ball;
      turned.turn_F =
          Eigen::AngleAxisd(0.37 * i + azimuth, Eigen::Vector3d(0.4, -0.6, 0.7).normalized());
      const Point<Robot> place{distance * std::cos(azimuth), distance * std::sin(azimuth)};

      EXPECT_EQ(eye.obstacles_at(place, turned), "") << distance << " m, " << azimuth;
    }
  }
}

TEST(BallAlone, OfOneColourIsNoObstacle) {
  BallEye eye({});

  expect_no_obstacles(eye, {});
}

TEST(BallAlone, WithAPatternIsNoObstacle) {
  BallEye eye({vision::ColourClass::kWhite, vision::ColourClass::kBlack});

  expect_no_obstacles(eye, {kWhite, BallPattern::kFootball, kBlack, {}});
  expect_no_obstacles(eye, {kWhite, BallPattern::kOctants, kBlack, {}});
}

// How many of forty balls are found that touch a robot right behind them; half of those have white
// markers.
std::size_t found_before_robots(BallEye& eye, const BallLook& ball) {
  std::size_t found = 0;
  for (int i = 0; i < 40; ++i) {
    const double azimuth = 0.5 + 0.7 * i;
    BallLook turned = ball;
    turned.turn_F =
        Eigen::AngleAxisd(0.37 * i + azimuth, Eigen::Vector3d(0.4, -0.6, 0.7).normalized());
    if (eye.sees_before_a_robot(0.6 + 0.025 * i, azimuth, turned, i % 2 == 1)) ++found;
  }
  return found;
}

TEST(BallBeforeARobot, IsFoundWithinAMetreAndAHalf) {
  BallEye plain({});
  BallEye patterned({vision::ColourClass::kWhite, vision::ColourClass::kBlack});

  EXPECT_EQ(found_before_robots(plain, {}), 40U);
  EXPECT_GT(found_before_robots(patterned, {kWhite, BallPattern::kFootball, kBlack, {}}), 30U);
  EXPECT_GT(found_before_robots(patterned, {kWhite, BallPattern::kOctants, kBlack, {}}), 30U);
}

}  // namespace
}  // namespace teamsight::sim
