// tests/vision/calibration/line_calibration_test.cpp: robots with bent mirrors drive over a field.
#include "vision/calibration/line_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <string>

#include <gtest/gtest.h>

#include "tests/vision/calibration/bent_camera.hpp"
#include "tests/vision/synthetic_points.hpp"

namespace teamsight::vision {
namespace {

std::vector<std::vector<Pixel>> drive_around(const BentCamera& camera,
                                             const FieldModel& field,
                                             int views,
                                             std::mt19937& random) {
  std::vector<std::vector<Pixel>> pixels;
  for (int i = 0; i < views; ++i) {
    pixels.push_back(see_lines(camera, field, random_pose(field, random), {}, random));
  }
  return pixels;
}

TEST(BentCamera, WithoutDefectsIsTheDrawnCamera) {
  EXPECT_LT(ground_error(BentCamera({}), CameraModel(drawn_camera())), 1e-4);
}

TEST(BentCamera, BendsAsTheCameraFileSays) {
  Defects defects;
  defects.focal_ratio = 0.01;
  defects.centre_px = {2.0, -1.0};
  defects.offset_m = {0.001, -0.0005, 0.0007};
  defects.tilt_rad = {0.006, -0.004};
  defects.head_rad = {0.005, 0.008};
  defects.height_m = 0.004;
  CameraParameters camera = drawn_camera();
  auto& mirror = std::get<ProfileMirror>(camera.mirror);
  mirror.focal_x_px *= 1.01;
  mirror.focal_y_px *= 1.01;
  mirror.centre_u_px += 2.0;
  mirror.centre_v_px -= 1.0;
  mirror.offset_C = {0.001, -0.0005, 0.0007};
  mirror.tilt_C = {0.006, -0.004};
  mirror.head_roll = 0.005;
  mirror.head_pitch = 0.008;
  mirror.pinhole_height += 0.004;

  EXPECT_LT(ground_error(BentCamera(defects), CameraModel(camera)), 1e-4);
  EXPECT_GT(ground_error(BentCamera(defects), CameraModel(drawn_camera())), 0.1);
}

TEST(LineCalibration, KnowsTheFloorOfBentRobotsToACentimetre) {
  const FieldModel field = test_field();
  const LineMap map(field);
  constexpr int kRobots = 4;
  for (int robot = 0; robot < kRobots; ++robot) {
    std::mt19937 random(static_cast<unsigned>(100 + robot));
    const BentCamera camera(random_defects(random));
    const auto pixels = drive_around(camera, field, 40, random);

    const LineCalibration found = calibrate_lines(map, drawn_camera(), pixels, {});

    const double before = ground_error(camera, CameraModel(drawn_camera()));
    const double after = ground_error(camera, CameraModel(found.camera));
    std::cout << "robot " << robot << ": before " << before << " m, after " << after
              << " m, predicted " << found.ground_sigma << " m, scale " << found.scale << '\n';
    EXPECT_FALSE(found.refusal.has_value());
    EXPECT_LT(after, 0.010);
  }
}

}  // namespace
}  // namespace teamsight::vision
