// tests/realdata/calibration_test.cpp: cameras of real robots, from their own lines.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "settings/load.hpp"
#include "tests/realdata/folders.hpp"
#include "tools/line_views.hpp"
#include "vision/calibration/line_calibration.hpp"

namespace teamsight {
namespace {

namespace fs = std::filesystem;
using test::data_dir;
using test::source_dir;
using vision::ViewResult;

// Of the points' distances from the paint, over all views; m.
double quantile(const vision::LineCalibration& result,
                std::vector<vision::PaintMiss> ViewResult::*which,
                double share) {
  std::vector<double> sizes;
  for (const ViewResult& view : result.views) {
    for (const vision::PaintMiss& miss : view.*which) sizes.push_back(std::abs(miss.distance));
  }
  if (sizes.empty()) return HUGE_VAL;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), sizes.begin() + at, sizes.end());
  return sizes[static_cast<std::size_t>(at)];
}

void print(const char* name, const vision::LineCalibration& result) {
  std::cout << name << ": median before " << quantile(result, &ViewResult::before, 0.5)
            << " m, after " << quantile(result, &ViewResult::after, 0.5) << " m; 90 % before "
            << quantile(result, &ViewResult::before, 0.9) << " m, after "
            << quantile(result, &ViewResult::after, 0.9) << " m; floor known to "
            << result.ground_sigma << " m\n";
}

vision::LineCalibration calibrate(const std::string& camera_name,
                                  const std::string& field_name,
                                  const std::vector<std::string>& views,
                                  double sigma_px) {
  const auto camera = settings::load_camera(source_dir() / "config/cameras" / camera_name);
  const FieldModel field = settings::load_field(source_dir() / "config/fields" / field_name);
  std::vector<std::string> paths;
  for (const std::string& view : views) paths.push_back(data_dir() / view);
  vision::LineCalibrationRules rules;
  rules.bundle.sigma_px = sigma_px;
  rules.bundle.max_distance = camera.scan.max_distance;
  rules.max_ground_sigma = 0.03;
  return vision::calibrate_lines(
      vision::LineMap(field), camera, tools::LineViews(paths, camera, field), rules);
}

class RealCamera : public ::testing::Test {
 protected:
  void SetUp() override {
    if (test::has_data("nubot_nudt")) return;
    GTEST_SKIP() << "no real data in " << data_dir();
  }
};

TEST_F(RealCamera, NubotOneAndTwoFitBetterThanWithTheTeamsOwnMirrors) {
  for (const std::string robot : {"1", "2"}) {
    const auto result = calibrate("nubot-nudt" + robot + ".textproto",
                                  "msl-18x12.textproto",
                                  {"nubot_nudt/robot" + robot + "-whites.txt"},
                                  0.6);

    print(("nubot robot " + robot).c_str(), result);
    EXPECT_FALSE(result.refusal.has_value());
    // A simple fit with the teams' own mirrors: 38 and 47 mm, 126 and 106 mm.
    EXPECT_LE(quantile(result, &ViewResult::after, 0.5), 0.038);
    EXPECT_LE(quantile(result, &ViewResult::after, 0.9), 0.126);
  }
}

TEST_F(RealCamera, NubotThreeFitsAfterACalibrationFromItsOwnLines) {
  const auto result = calibrate(
      "nubot-nudt3.textproto", "nubot-18x8.textproto", {"nubot_nudt/robot3-whites.txt"}, 0.6);

  print("nubot robot 3", result);
  EXPECT_FALSE(result.refusal.has_value());
  EXPECT_GT(quantile(result, &ViewResult::before, 0.5), 0.05);
  EXPECT_LT(quantile(result, &ViewResult::after, 0.5), 0.03);
  EXPECT_LT(quantile(result, &ViewResult::after, 0.9), 0.08);
}

TEST_F(RealCamera, NubotOneAndTwoStayAsGoodAsTheirTeamMadeThem) {
  for (const std::string robot : {"1", "2"}) {
    const auto result = calibrate("nubot-nudt" + robot + ".textproto",
                                  "nubot-18x12.textproto",
                                  {"nubot_nudt/robot" + robot + "-whites.txt"},
                                  0.6);

    print(("nubot robot " + robot).c_str(), result);
    EXPECT_FALSE(result.refusal.has_value());
    EXPECT_LT(quantile(result, &ViewResult::after, 0.5),
              quantile(result, &ViewResult::before, 0.5));
    EXPECT_LT(quantile(result, &ViewResult::after, 0.9), 0.13);
  }
}

TEST_F(RealCamera, KasselsFourFramesAgreeOnCentreAndTilt) {
  std::vector<std::string> frames;
  for (const char* number : {"1", "2", "3", "4"}) {
    frames.push_back(std::string("cnc_kassel/log-image-000") + number + ".raw");
  }

  const auto result = calibrate("kassel-nase.textproto", "kassel-lab.textproto", frames, 0.3);

  print("kassel", result);
  const auto& centre = result.views.at(1).X_FR;
  std::cout << "kassel image 2: x " << centre.x() << " m, y " << centre.y() << " m\n";
  EXPECT_FALSE(result.refusal.has_value());
  EXPECT_LT(quantile(result, &ViewResult::after, 0.5), 0.012);
  EXPECT_LT(quantile(result, &ViewResult::after, 0.5),
            0.6 * quantile(result, &ViewResult::before, 0.5));
  EXPECT_LT(centre.origin().vector().norm(), 0.10);
}

}  // namespace
}  // namespace teamsight
