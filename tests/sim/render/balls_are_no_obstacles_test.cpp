// tests/sim/render/balls_are_no_obstacles_test.cpp: a ball alone on the carpet in rendered frames
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

class LonelyBall {
 public:
  explicit LonelyBall(const std::vector<vision::ColourClass>& pattern)
      : camera_(camera_with(pattern)),
        renderer_(camera_, field_, {}),
        perception_(camera_, field_) {}

  // What is taken for obstacles.
  std::string obstacles_at(const Point<Robot>& p_RB, const BallLook& look) {
    Scene scene;
    scene.X_FR = kHere;
    const Point<Field> p_F = kHere * p_RB;
    SceneBall ball;
    ball.p_FB = {p_F.x, p_F.y, ball.radius};
    ball.look = look;
    scene.balls.push_back(ball);
    renderer_.draw(scene, random_, bytes_);
    vision::MotionPrior prior;
    prior.X_FR = kHere;
    const auto seen =
        perception_.see({bytes_, camera_.width_px, camera_.height_px, camera_.format}, prior);
    if (!seen) return "no frame";
    std::string words;
    for (const ObstacleSighting& obstacle : (*seen)->obstacles) {
      words += std::to_string(obstacle.p_RO.x) + ", " + std::to_string(obstacle.p_RO.y) + "; ";
    }
    return words;
  }

 private:
  FieldModel field_ = settings::load_field(test::source_path("config/fields/msl-2024.textproto"));
  vision::CameraParameters camera_;
  Renderer renderer_;
  vision::Perception perception_;
  Random random_{5};
  std::vector<std::uint8_t> bytes_;
};

void expect_no_obstacles(LonelyBall& eye, const BallLook& ball) {
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
  LonelyBall eye({});

  expect_no_obstacles(eye, {});
}

TEST(BallAlone, WithAPatternIsNoObstacle) {
  LonelyBall eye({vision::ColourClass::kWhite, vision::ColourClass::kBlack});

  expect_no_obstacles(eye, {kWhite, BallPattern::kFootball, kBlack, {}});
  expect_no_obstacles(eye, {kWhite, BallPattern::kOctants, kBlack, {}});
}

}  // namespace
}  // namespace teamsight::sim
