// tests/sim/render/mirror_parts_test.cpp: balls in rendered frames of the founding paper's mirror,
// whose ring shows the floor beside the robot a second time.
#include "vision/mirror_parts.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "settings/load.hpp"
#include "settings/mirror_file.hpp"
#include "sim/render/renderer.hpp"
#include "sim/show.hpp"
#include "tests/support/process.hpp"
#include "vision/mirror/design.hpp"
#include "vision/perception.hpp"

namespace teamsight::sim {
namespace {

// The paper's mirror over a sensor of 1.3 Mpx; colours and mounting of the shipped simulated eye.
vision::CameraParameters eye_with_ring(double inner_radius_px) {
  vision::CameraParameters camera =
      settings::load_camera(test::source_path("config/cameras/sim-isometric.textproto"));
  const auto mirror = mirror::design(
      settings::load_mirror(test::source_path("config/mirrors/multi_part.textproto")).parameters);
  if (!mirror) return camera;
  vision::ProfileMirror profile;
  profile.focal_x_px = mirror->assembly.focal_px;
  profile.focal_y_px = mirror->assembly.focal_px;
  profile.centre_u_px = 639.5;
  profile.centre_v_px = 511.5;
  profile.pinhole_height = mirror->assembly.pinhole_height;
  for (const mirror::Part& part : mirror->assembly.profile.parts) {
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      const bool is_joint = i == 0 && !profile.profile.empty();
      if (is_joint && !part.kinked_start) continue;
      const double beside = is_joint ? 1e-9 : 0.0;
      profile.profile.push_back({part.nodes[i].x + beside, part.nodes[i].y});
    }
  }
  camera.width_px = 1280;
  camera.height_px = 1024;
  camera.mirror = profile;
  camera.mask.inner_radius_px = inner_radius_px;
  camera.mask.outer_radius_px = 508.0;
  return camera;
}

constexpr double kLensAlone = 18.0;  // px; of the mask
constexpr double kBlind = 60.0;      // px; what is nearer than 1 m is seen in the ring alone
constexpr std::uint8_t kRing = 1;    // part of the mirror

/// A robot on the field that looks through such an eye.
struct Eye {
  explicit Eye(double inner_radius_px) : Eye(eye_with_ring(inner_radius_px)) {}

  explicit Eye(const vision::CameraParameters& of)
      : camera(of),
        renderer(camera, field, with_body()),
        perception(camera, field) {}

  static PictureParameters with_body() {
    PictureParameters look;
    look.body = low_body();
    return look;
  }

  const vision::FrameObservation& see(const std::vector<Point3<Robot>>& balls,
                                      const std::vector<Point<Robot>>& robots = {}) {
    Scene scene;
    scene.X_FR = {1.5, 1.2, 0.4};
    for (const Point3<Robot>& p_R : balls) {
      const Point<Field> p_F = scene.X_FR * Point<Robot>{p_R.x, p_R.y};
      scene.balls.push_back({{p_F.x, p_F.y, p_R.z}, {}});
    }
    for (const Point<Robot>& p_R : robots) {
      SceneRobot robot;
      robot.p_F = scene.X_FR * p_R;
      scene.robots.push_back(robot);
    }
    renderer.draw(scene, random, bytes);
    const auto seen = perception.see({bytes, camera.width_px, camera.height_px, camera.format},
                                     {scene.X_FR, {}, {}});
    return seen ? **seen : nothing;
  }

  const FieldModel field =
      settings::load_field(test::source_path("config/fields/robocup-2001.textproto"));
  vision::CameraParameters camera;
  Renderer renderer;
  vision::Perception perception;
  Random random{11};
  std::vector<std::uint8_t> bytes;
  const vision::FrameObservation nothing{};
};

// On the floor, to the left ahead.
Point3<Robot> ball_at(double distance) {
  return {0.8 * distance, 0.6 * distance, 0.11};
}

// Between the ball's ray and its middle; m.
double miss_of(const BallRay& ball, const Point3<Robot>& p_RB) {
  const Eigen::Vector3d way = p_RB.vector() - ball.ray_R.origin.vector();
  return way.cross(ball.ray_R.direction).norm();
}

TEST(MirrorParts, AreToldApartByWhereRaysJump) {
  const vision::CameraParameters camera = eye_with_ring(kLensAlone);
  const vision::CameraModel model(camera);
  const vision::RayTable rays(model, camera.width_px, camera.height_px);

  const vision::MirrorParts parts(rays, model.centre());

  ASSERT_TRUE(parts.are_several());
  const auto part_at = [&](std::size_t radius_px) {
    return parts[std::size_t{511} * camera.width_px + 639 + radius_px];
  };
  EXPECT_EQ(part_at(10), vision::MirrorParts::kInner);
  EXPECT_EQ(part_at(385), vision::MirrorParts::kInner) << "the kink is at 391.5 px";
  EXPECT_EQ(part_at(398), kRing);
  EXPECT_EQ(part_at(505), kRing);
  EXPECT_EQ(part_at(520), vision::MirrorParts::kNone);
}

TEST(MirrorParts, AreOneWithoutAKink) {
  const vision::CameraParameters camera =
      settings::load_camera(test::source_path("config/cameras/sim-isometric.textproto"));
  const vision::CameraModel model(camera);
  const vision::RayTable rays(model, camera.width_px, camera.height_px);

  EXPECT_FALSE(vision::MirrorParts(rays, model.centre()).are_several());
}

TEST(BallInMirrorParts, IsOneThoughTwoPartsShowIt) {
  Eye eye(kLensAlone);
  for (const double distance : {0.38, 0.42, 0.5}) {
    const Point3<Robot> p_RB = ball_at(distance);

    const vision::FrameObservation& seen = eye.see({p_RB});

    ASSERT_EQ(seen.balls.size(), 1U) << distance;
    EXPECT_LT(miss_of(seen.balls[0], p_RB), 0.03) << distance;
    const double truth = (p_RB.vector() - seen.balls[0].ray_R.origin.vector()).norm();
    const vision::BallRange& range = seen.ball_ranges[0];
    EXPECT_NEAR(range.on_floor, truth, 3.0 * range.sigma_on_floor) << distance;
    EXPECT_NEAR(range.by_size, truth, 3.0 * range.sigma_by_size) << distance;
  }
}

TEST(BallInMirrorParts, IsTheImageInThePartThatShowsItBetter) {
  Eye eye(kLensAlone);

  const std::uint8_t near = eye.see({ball_at(0.42)}).ball_pixels.at(0).mirror_part;
  const std::uint8_t far = eye.see({ball_at(0.55)}).ball_pixels.at(0).mirror_part;

  EXPECT_EQ(near, kRing) << "most of it, thirteen times as large";
  EXPECT_EQ(far, vision::MirrorParts::kInner) << "the ring shows its rim alone";
}

TEST(BallInMirrorParts, IsOneWhereTheSeamAndTheRimCutIt) {
  Eye eye(kBlind);
  for (const double distance : {0.36, 0.42, 0.5}) {
    const Point3<Robot> p_RB = ball_at(distance);

    const vision::FrameObservation& seen = eye.see({p_RB});

    ASSERT_EQ(seen.balls.size(), 1U) << distance;
    const BallRay& ball = seen.balls[0];
    EXPECT_LT(miss_of(ball, p_RB), 0.03) << distance;
    const double truth = (p_RB.vector() - ball.ray_R.origin.vector()).norm();
    EXPECT_NEAR(ball.angular_radius, std::asin(0.11 / truth), 0.01) << distance;
    EXPECT_GT(ball.confidence, 0.8) << distance;
    EXPECT_TRUE(seen.ball_pixels[0].on_carpet) << distance;
  }
}

TEST(BallInMirrorParts, IsNotTheOtherBallOfTwo) {
  Eye eye(kLensAlone);

  const auto in_line = eye.see({ball_at(0.42), ball_at(0.8)}).balls;
  const auto abreast = eye.see({{0.43, 0.12, 0.11}, {0.43, -0.12, 0.11}}).balls;

  EXPECT_EQ(in_line.size(), 2U);
  EXPECT_EQ(abreast.size(), 2U);
}

TEST(BallInMirrorParts, IsNotInventedInTheRing) {
  Eye eye(kLensAlone);

  EXPECT_TRUE(eye.see({}).balls.empty());
}

// The shipped camera file.
struct ShippedRing : testing::Test {
  Eye eye{settings::load_camera(test::source_path("config/cameras/sim-ring.textproto"))};
};

TEST_F(ShippedRing, HasTheDesignsParts) {
  const vision::CameraModel model(eye.camera);
  const vision::RayTable rays(model, eye.camera.width_px, eye.camera.height_px);
  const vision::CameraModel designed(eye_with_ring(kLensAlone));

  EXPECT_TRUE(vision::MirrorParts(rays, model.centre()).are_several());
  for (const double radius : {60.0, 200.0, 340.0, 385.0, 398.0, 450.0, 505.0}) {
    const auto ray = model.ray({639.5 + radius, 511.5});
    const auto wanted = designed.ray({639.5 + radius, 511.5});
    ASSERT_TRUE(ray && wanted) << radius;
    EXPECT_LT((ray->direction - wanted->direction).norm(), 1e-3) << radius;
  }
}

TEST_F(ShippedRing, FindsABallInTheRingAndOneFarAway) {
  const Point3<Robot> near = ball_at(0.42);
  const Point3<Robot> far{-2.5, 0.5, 0.11};

  const vision::FrameObservation& seen = eye.see({near, far});

  ASSERT_EQ(seen.balls.size(), 2U);
  const bool near_first = miss_of(seen.balls[0], near) < miss_of(seen.balls[1], near);
  EXPECT_LT(miss_of(seen.balls[near_first ? 0 : 1], near), 0.03);
  EXPECT_LT(miss_of(seen.balls[near_first ? 1 : 0], far), 0.03);
  EXPECT_EQ(seen.ball_pixels[near_first ? 0 : 1].mirror_part, kRing);
  EXPECT_EQ(seen.ball_pixels[near_first ? 1 : 0].mirror_part, vision::MirrorParts::kInner);
}

TEST_F(ShippedRing, FindsItsPlaceByLinesAndTheRobotsAroundIt) {
  const std::vector<Point<Robot>> robots{{1.4, 0.3}, {-0.8, -1.8}};

  const vision::FrameObservation& seen = eye.see({}, robots);

  EXPECT_GT(seen.line_points.size(), 100U);
  EXPECT_NE(seen.posture.status, PostureStatus::kLost);
  // Nobody has said which half it stands on, and both look alike.
  const Pose<Field, Robot> there = seen.posture.X_FR.x() > 0.0
                                       ? seen.posture.X_FR
                                       : mirrored(seen.posture.X_FR, eye.field.centre);
  EXPECT_NEAR(there.x(), 1.5, 0.02);
  EXPECT_NEAR(there.y(), 1.2, 0.02);
  EXPECT_NEAR(there.theta(), 0.4, 0.005);
  ASSERT_EQ(seen.obstacles.size(), robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const Eigen::Vector2d middle = robots[i].vector();
    const Eigen::Vector2d foot = middle * (1.0 - 0.25 / middle.norm());
    EXPECT_LT((seen.obstacles[i].p_RO.vector() - foot).norm(), 0.1) << i;
  }
}

}  // namespace
}  // namespace teamsight::sim
