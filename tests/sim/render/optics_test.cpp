// tests/sim/render/optics_test.cpp: lines of sight against closed forms, and beside vision's model.
#include "sim/render/optics.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/render/defects.hpp"
#include "tests/sim/render/eyes.hpp"
#include "vision/camera_model.hpp"

namespace teamsight::sim {
namespace {

// Where a line of sight meets the floor; far away if it does not.
Eigen::Vector2d on_floor(const std::optional<Ray<Robot>>& ray) {
  if (!ray.has_value() || ray->direction.z() >= 0.0) {
    return {1e6, 1e6};
  }
  const double t = ray->origin.z / -ray->direction.z();
  return ray->origin.vector().head<2>() + t * ray->direction.head<2>();
}

// Distance on the floor of the pixel `radius` above the centre, in the robot's forward direction.
double distance_at(const vision::CameraParameters& camera, double radius) {
  return on_floor(Optics(camera).look({320.0, 240.0 - radius})).x();
}

TEST(Optics, APlaneMirrorShowsTheFloorAsFromItsMirrorImage) {
  for (const double radius : {10.0, 80.0, 200.0}) {
    EXPECT_NEAR(distance_at(eye_below(plane), radius),
                (kPinholeHeight + 2.0 * 0.15) * radius / kFocal,
                1e-9);
  }
}

TEST(Optics, AConeTurnsSightsByTwiceItsSlope) {
  const double slope = std::atan(0.55);
  for (const double radius : {10.0, 60.0, 150.0}) {
    const double up = radius / kFocal;  // tangent of the angle from the axis
    const double x = 0.12 * up / (1.0 - 0.55 * up);
    const double elevation = 2.0 * slope - std::atan2(1.0, up);
    const double expected = x + (kPinholeHeight + 0.12 + 0.55 * x) / std::tan(-elevation);
    EXPECT_NEAR(distance_at(eye_below(cone), radius), expected, 1e-7) << radius;
  }
}

TEST(Optics, ASphereReflectsAboutItsRadius) {
  for (const double radius : {10.0, 60.0, 120.0}) {
    const Eigen::Vector2d sight = Eigen::Vector2d(radius, kFocal).normalized();
    const Eigen::Vector2d centre(0.0, 0.22);
    const double along = sight.dot(centre);
    const double t = along - std::sqrt(along * along - centre.squaredNorm() + 0.01);
    const Eigen::Vector2d hit = t * sight;
    const Eigen::Vector2d normal = (hit - centre) / 0.1;
    const Eigen::Vector2d away = sight - 2.0 * sight.dot(normal) * normal;
    const double expected = hit.x() + (kPinholeHeight + hit.y()) * away.x() / -away.y();
    EXPECT_NEAR(distance_at(eye_below(sphere), radius), expected, 1e-6 * expected) << radius;
  }
}

TEST(Optics, APlaneMirrorTiltedTurnsTheAxisTwiceAsMuch) {
  vision::CameraParameters camera = eye_below(plane);
  mirror_of(camera).tilt_C[0] = 0.01;  // about image right: the mirror's far edge, image bottom, up

  const Ray<Robot> axis = Optics(camera).look({320.0, 240.0}).value();

  const double turned = std::atan2(axis.direction.head<2>().norm(), -axis.direction.z());
  EXPECT_NEAR(turned, 0.02, 1e-9);
}

TEST(Optics, ASphereMovedSidewaysIsSeenWhereItsMiddleIs) {
  vision::CameraParameters camera = eye_below(sphere);
  mirror_of(camera).offset_C[0] = 0.002;  // towards image right, which is the robot's left

  // Through the moved sphere's middle the sight comes back on itself.
  const double u = 320.0 + kFocal * 0.002 / 0.22;
  const Ray<Robot> back = Optics(camera).look({u, 240.0}).value();

  const double turned = std::atan2(back.direction.head<2>().norm(), -back.direction.z());
  EXPECT_NEAR(turned, std::atan2(0.002, 0.22), 1e-6);
}

TEST(Optics, AHeadPitchedDownSeesStraightDownAhead) {
  vision::CameraParameters camera = eye_below(plane);
  mirror_of(camera).head_pitch = 0.02;  // about R's y axis: x forward turns down, z forward

  const Eigen::Vector2d floor = on_floor(Optics(camera).look({320.0, 240.0}));

  // The axis points 0.02 forward of up, comes back along itself and meets the floor behind.
  EXPECT_NEAR(floor.x(), -kPinholeHeight * std::tan(0.02), 1e-9);
  EXPECT_NEAR(floor.y(), 0.0, 1e-9);
}

TEST(Optics, ARadialTableKeepsItsRowsAndItsDirections) {
  vision::CameraParameters camera = eye_below(plane);
  camera.mirror = vision::RadialTable{
      320.0,
      240.0,
      0.75,
      {{50.0, 0.5, 0.1}, {100.0, 1.1, 0.1}, {150.0, 2.0, 0.1}, {200.0, 4.0, 0.1}}};
  const Optics optics(camera);

  const Eigen::Vector2d ahead = on_floor(optics.look({320.0, 140.0}));
  const Eigen::Vector2d left = on_floor(optics.look({470.0, 240.0}));

  EXPECT_NEAR(ahead.x(), 1.1, 1e-9);
  EXPECT_NEAR(ahead.y(), 0.0, 1e-9);
  EXPECT_NEAR(left.y(), 2.0, 1e-9);
  EXPECT_FALSE(optics.look({320.0, 30.0}).has_value());
}

TEST(Optics, FindsAPointWhereItLooksAtIt) {
  const Optics optics(with_defects(eye_below(sphere), draw_defects(3)));
  for (const Point3<Robot>& p_R :
       {Point3<Robot>{2.0, 1.0, 0.0}, {-0.8, 0.4, 0.5}, {0.3, -4.0, 0.11}}) {
    const auto place = optics.find(p_R);
    ASSERT_TRUE(place.has_value());
    const Ray<Robot> ray = optics.look(*place).value();
    const Eigen::Vector3d way = p_R.vector() - ray.origin.vector();
    EXPECT_LT(way.normalized().cross(ray.direction).norm(), 1e-6);
  }
}

// Two programs that share no geometry say the same of thirty eyes with defects.
TEST(Optics, AgreesWithTheCameraModelOfVision) {
  const auto bowl = [](double x) {
    return 0.12 + 0.2 * x + 3.0 * x * x;
  };
  double worst = 0.0;
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    vision::CameraParameters camera = with_defects(eye_below(bowl), draw_defects(seed));
    camera.mirrored = seed % 2 == 0;
    camera.forward = 0.3 * seed;
    const Optics optics(camera);
    const vision::CameraModel model(camera);
    for (const ImagePlace& place : {ImagePlace{400.0, 200.0}, {250.5, 300.25}, {330.0, 120.0}}) {
      const auto ours = optics.look(place);
      const auto theirs = model.ray({place.u, place.v});
      ASSERT_TRUE(ours.has_value() && theirs.has_value());
      worst = std::max(worst, (ours->direction - theirs->direction).norm());
      worst = std::max(worst, (ours->origin.vector() - theirs->origin.vector()).norm());
    }
  }
  EXPECT_LT(worst, 1e-6);
}

}  // namespace
}  // namespace teamsight::sim
