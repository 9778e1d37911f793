// tests/vision/calibration/line_calibration_test.cpp: robots with bent mirrors drive over a field.
#include "vision/calibration/line_calibration.hpp"

#include <array>
#include <cmath>
#include <iostream>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vision/calibration/bent_camera.hpp"
#include "tests/vision/synthetic_points.hpp"
#include "vision/calibration/floor_look.hpp"

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
  for (const unsigned seed : {100U, 101U}) {
    std::mt19937 random(seed);
    const BentCamera camera(random_defects(random));
    const auto pixels = drive_around(camera, field, 14, random);

    const LineCalibration found = calibrate_lines(map, drawn_camera(), pixels, {});

    const double before = ground_error(camera, CameraModel(drawn_camera()));
    const double after = ground_error(camera, CameraModel(found.camera));
    std::cout << "robot " << seed << ": before " << before << " m, after " << after
              << " m, predicted " << found.ground_sigma << " m\n";
    EXPECT_FALSE(found.refusal.has_value());
    EXPECT_GT(before, 0.05);
    EXPECT_LT(after, 0.010);
    EXPECT_LT(after, 5.0 * found.ground_sigma);
  }
}

TEST(LineCalibration, LooksForTheLinesThroughTheCameraItFound) {
  const FieldModel field = test_field();
  std::mt19937 random(102);
  const BentCamera camera(random_defects(random));
  const auto pixels = drive_around(camera, field, 8, random);
  // A detector that puts the lines farther out the more its camera is wrong.
  const auto look = [&](const CameraParameters& eye) {
    const double share = 0.01 * ground_error(camera, CameraModel(eye));
    auto found = pixels;
    for (std::vector<Pixel>& view : found) {
      for (Pixel& pixel : view) {
        pixel.u += share * (pixel.u - 319.5);
        pixel.v += share * (pixel.v - 239.5);
      }
    }
    return found;
  };
  const LineMap map(field);

  const auto once = calibrate_lines(map, drawn_camera(), look(drawn_camera()), {});
  const auto again = calibrate_lines(map, drawn_camera(), look, {});

  EXPECT_FALSE(again.refusal.has_value());
  EXPECT_GT(ground_error(camera, CameraModel(once.camera)), 0.010);
  EXPECT_LT(ground_error(camera, CameraModel(again.camera)), 0.003);
}

TEST(LineCalibration, RefusesViewsThatShowOneLineOnly) {
  FieldModel field;
  field.name = "one line";
  field.length = 12.0;
  field.width = 8.0;
  field.surround = 1.0;
  field.line_width = 0.125;
  field.lines.push_back({"line", {-6, 0}, {6, 0}, LineFamily::kOther});
  std::mt19937 random(3);
  const auto pixels = drive_around(BentCamera(random_defects(random)), field, 3, random);

  const LineCalibration found = calibrate_lines(LineMap(field), drawn_camera(), pixels, {});

  ASSERT_TRUE(found.refusal.has_value());
}

TEST(LineCalibration, RefusesASingleView) {
  const FieldModel field = test_field();
  std::mt19937 random(5);
  const auto pixels = drive_around(BentCamera(random_defects(random)), field, 1, random);
  LineCalibrationRules rules;
  rules.max_ground_sigma = 0.005;

  const LineCalibration found = calibrate_lines(LineMap(field), drawn_camera(), pixels, rules);

  EXPECT_EQ(found.refusal, LineRefusal::kNotDetermined);
  EXPECT_GT(found.ground_sigma, 0.005);
}

TEST(LineCalibration, RefusesAnotherField) {
  FieldModel field = test_field();
  std::mt19937 random(6);
  const auto pixels = drive_around(BentCamera({}), field, 3, random);
  FieldModel other = test_field();
  for (FieldLine& line : other.lines) {
    line.from.y *= 0.6;
    line.to.y *= 0.6;
  }

  const LineCalibration found = calibrate_lines(LineMap(other), drawn_camera(), pixels, {});

  EXPECT_TRUE(found.refusal.has_value());
}

TEST(LineCalibration, FindsTheRadialTableOfAMirrorOfUnknownShape) {
  // The same bent camera, described by a table that was measured with another mirror.
  const FieldModel field = test_field();
  std::mt19937 random(7);
  Defects defects = random_defects(random);
  defects.tilt_rad.setZero();
  defects.offset_m.setZero();
  const BentCamera camera(defects);
  CameraParameters base = drawn_camera();
  const CameraModel drawn(base);
  RadialTable table;
  table.centre_u_px = 322.0;
  table.centre_v_px = 238.0;
  table.mirror_height = 0.77;
  for (int radius = 20; radius <= 220; radius += 10) {
    const auto floor = drawn.on_plane({319.5 + 1.02 * radius, 239.5}, 0.0);
    if (!floor || floor->x > 12.0) break;
    table.rows.push_back({1.0 * radius, floor->x, 0.5});
  }
  base.mirror = table;
  const auto pixels = drive_around(camera, field, 14, random);

  const LineCalibration found = calibrate_lines(LineMap(field), base, pixels, {});

  const double before = ground_error(camera, CameraModel(base));
  const double after = ground_error(camera, CameraModel(found.camera));
  std::cout << "table: before " << before << " m, after " << after << " m\n";
  EXPECT_FALSE(found.refusal.has_value());
  EXPECT_GT(before, 0.05);
  EXPECT_LT(after, 0.020);
}

TEST(FloorLook, SlopesAreThoseOfTheDistance) {
  // The hand-written slopes over posture and knobs against a turn of each.
  const FieldModel field = test_field();
  const LineMap map(field);
  const CameraParameters camera = drawn_camera();
  std::vector<CameraKnob> knobs;
  for (const KnobPrior& prior : knobs_of(camera)) knobs.push_back(prior.knob);
  const Eigen::VectorXd turn = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(knobs.size()));
  const auto distance = [&](const Eigen::VectorXd& by, const Pose<Field, Robot>& X_FR) {
    const auto looker = FloorLooker::make(camera, knobs, by, false);
    return miss_of(map, X_FR, *looker->look({420.0, 180.0}), 0.3).distance;
  };
  for (const double theta : {0.0, 3.14, -3.14, 0.7}) {
    const Pose<Field, Robot> X_FR(1.0, 0.5, theta);
    const auto looker = FloorLooker::make(camera, knobs, turn, true);

    const FloorMiss miss = miss_of(map, X_FR, *looker->look({420.0, 180.0}), 0.3);

    constexpr double kStep = 1e-5;
    const std::array<Pose<Field, Robot>, 3> ahead{Pose<Field, Robot>(1.0 + kStep, 0.5, theta),
                                                  Pose<Field, Robot>(1.0, 0.5 + kStep, theta),
                                                  Pose<Field, Robot>(1.0, 0.5, theta + kStep)};
    for (std::size_t i = 0; i < 3; ++i) {
      const double numeric = (distance(turn, ahead.at(i)) - miss.distance) / kStep;
      EXPECT_NEAR(miss.by_posture[static_cast<Eigen::Index>(i)], numeric, 1e-3);
    }
    for (Eigen::Index k = 0; k < turn.size(); ++k) {
      const double step = 0.3 * nudge_of(knobs[static_cast<std::size_t>(k)]);
      Eigen::VectorXd by = turn;
      by[k] = step;
      const double numeric = (distance(by, X_FR) - miss.distance) / step;
      EXPECT_NEAR(miss.by_knob[k], numeric, 0.02 * std::abs(numeric) + 1e-4);
    }
  }
}

}  // namespace
}  // namespace teamsight::vision
