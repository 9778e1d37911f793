// tests/vision/resized_camera_test.cpp: another sensor behind the same mirror sees the same world.
#include "vision/resized_camera.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "vision/camera_model.hpp"

namespace teamsight::vision {
namespace {

CameraParameters table_camera() {
  CameraParameters camera;
  camera.width_px = 640;
  camera.height_px = 480;
  camera.forward = 1.0;
  RadialTable table;
  table.centre_u_px = 310.0;  // off the middle
  table.centre_v_px = 245.5;
  table.mirror_height = 0.8;
  for (int radius = 20; radius <= 220; radius += 20) {
    table.rows.push_back({1.0 * radius, 0.7 * std::tan(0.0065 * radius), 0.5});
  }
  camera.mirror = table;
  return camera;
}

CameraParameters profile_camera() {
  CameraParameters camera = table_camera();
  ProfileMirror mirror;
  mirror.focal_x_px = mirror.focal_y_px = 800.0;
  mirror.centre_u_px = 325.0;
  mirror.centre_v_px = 235.0;
  mirror.pinhole_height = 0.5;
  mirror.profile = {{0.0, 0.15}, {0.02, 0.16}, {0.04, 0.185}, {0.06, 0.22}};
  camera.mirror = mirror;
  return camera;
}

// Where the new picture shows what the old one shows at (u, v).
void expect_same_ray(const CameraParameters& camera, double u, double v) {
  const CameraParameters large = resized(camera, 1280, 1024);
  const double new_u = 639.5 + 2.0 * (u - 319.5);
  const double new_v = 511.5 + 2.0 * (v - 239.5);

  const auto before = CameraModel(camera).ray({u, v});
  const auto after = CameraModel(large).ray({new_u, new_v});

  ASSERT_TRUE(before.has_value());
  ASSERT_TRUE(after.has_value());
  EXPECT_NEAR((after->origin.vector() - before->origin.vector()).norm(), 0.0, 1e-9);
  EXPECT_NEAR((after->direction - before->direction).norm(), 0.0, 1e-9);
}

TEST(ResizedCamera, SeesTheSameThroughARadialTable) {
  expect_same_ray(table_camera(), 402.0, 170.0);
}

TEST(ResizedCamera, SeesTheSameThroughAProfile) {
  expect_same_ray(profile_camera(), 345.0, 250.0);
}

TEST(ResizedCamera, TakesMaskAndWindowsWithIt) {
  CameraParameters camera = table_camera();
  camera.mask.outer_radius_px = 229.0;
  camera.mask.polygons = {{{0.0, 0.0}, {639.0, 0.0}, {319.5, 239.5}}};
  camera.sensors.push_back({"ball", SensorKind::kBall, {}, {camera.mask.polygons[0]}, 0.5});

  const CameraParameters large = resized(camera, 1280, 1024);

  const Polygon expected{{0.5, 32.5}, {1278.5, 32.5}, {639.5, 511.5}};
  EXPECT_DOUBLE_EQ(large.mask.outer_radius_px, 458.0);
  EXPECT_EQ(large.mask.polygons[0], expected);
  EXPECT_EQ(large.sensors[0].windows[0], expected);
}

TEST(ResizedCamera, KeepsToTheTighterSide) {
  CameraParameters camera = table_camera();
  camera.mask.outer_radius_px = 200.0;

  EXPECT_DOUBLE_EQ(resized(camera, 1280, 480).mask.outer_radius_px, 200.0);
  EXPECT_DOUBLE_EQ(resized(camera, 320, 480).mask.outer_radius_px, 100.0);
}

TEST(ResizedCamera, ClaimsNoCalibrationOfAnotherSensor) {
  CameraParameters camera = table_camera();
  camera.calibration = CalibrationRecord{};

  EXPECT_FALSE(resized(camera, 1280, 1024).calibration.has_value());
}

}  // namespace
}  // namespace teamsight::vision
