// tests/realdata/vision_kassel_test.cpp: postures from the Kassel robot's recorded frames.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "settings/load.hpp"
#include "tests/realdata/folders.hpp"
#include "tools/image_file.hpp"
#include "tools/sight_drawing.hpp"
#include "vision/perception.hpp"

namespace teamsight {
namespace {

namespace fs = std::filesystem;
using test::data_dir;
using test::source_dir;

fs::path frame_path(int number) {
  return data_dir() / "cnc_kassel" / ("log-image-000" + std::to_string(number) + ".raw");
}

double median(std::vector<double> values, double share = 0.5) {
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

class KasselFrames : public ::testing::Test {
 protected:
  void SetUp() override {
    if (fs::exists(frame_path(1))) return;
    std::cerr << "\n*** NO REAL DATA: " << frame_path(1)
              << " is not there; set TEAMSIGHT_DATA ***\n";
    GTEST_SKIP() << "no real data in " << data_dir();
  }

  [[nodiscard]] static vision::CameraParameters camera() {
    return settings::load_camera(source_dir() / "config/cameras/kassel-nase.textproto");
  }

  [[nodiscard]] static FieldModel field() {
    return settings::load_field(source_dir() / "config/fields/kassel-lab.textproto");
  }

  [[nodiscard]] static PostureEstimate posture_in(vision::Perception& perception,
                                                  int number,
                                                  const vision::MotionPrior& prior) {
    const auto frame = tools::read_image(frame_path(number), camera());
    const auto seen = perception.see(frame.view(), prior);
    EXPECT_TRUE(seen);
    return seen ? (*seen)->posture : PostureEstimate{};
  }
};

TEST_F(KasselFrames, StandsOnTheCentreMarkInImage2WithoutAPrior) {
  vision::Perception perception(camera(), field());

  const PostureEstimate posture = posture_in(perception, 2, {});

  EXPECT_NE(posture.status, PostureStatus::kLost);
  EXPECT_LT(posture.X_FR.origin().vector().norm(), 0.05);
}

TEST_F(KasselFrames, StandsOnTheCentreMarkInImage2FromTwentyRandomPriors) {
  vision::Perception perception(camera(), field());
  std::mt19937 random(2015);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  std::uniform_real_distribution<double> heading(-std::numbers::pi, std::numbers::pi);
  for (int i = 0; i < 20; ++i) {
    vision::MotionPrior prior;
    prior.X_FR = Pose<Field, Robot>(place(random), place(random), heading(random));
    prior.cov = Eigen::Vector3d(1.0, 1.0, 1.0).asDiagonal();
    prior.half_log_odds = 3.0;

    const PostureEstimate posture = posture_in(perception, 2, prior);

    EXPECT_NE(posture.status, PostureStatus::kLost);
    EXPECT_LT(posture.X_FR.origin().vector().norm(), 0.10) << "prior " << i;
  }
}

TEST_F(KasselFrames, FollowsAShiftedFieldFile) {
  const Eigen::Vector2d offset{1.0, 0.5};
  vision::Perception perception(camera(), shifted(field(), offset));

  const PostureEstimate posture = posture_in(perception, 2, {});

  EXPECT_NE(posture.status, PostureStatus::kLost);
  EXPECT_LT((posture.X_FR.origin().vector() - offset).norm(), 0.10);
}

TEST_F(KasselFrames, PutsTheLinePointsOfAllFramesOntoTheLines) {
  vision::Perception perception(camera(), field());
  for (int number = 1; number <= 4; ++number) {
    const auto frame = tools::read_image(frame_path(number), camera());
    const auto seen = perception.see(frame.view(), {});
    ASSERT_TRUE(seen);
    const vision::FrameObservation& observation = **seen;
    tools::draw_sight("realdata-drawings", {frame_path(number), frame, {}}, field(), observation);
    ASSERT_NE(observation.posture.status, PostureStatus::kLost) << "image " << number;
    std::vector<double> inliers;
    std::vector<double> all;
    for (std::size_t i = 0; i < observation.line_residuals.size(); ++i) {
      all.push_back(std::abs(observation.line_residuals[i]));
      if (observation.line_fits[i]) inliers.push_back(all.back());
    }
    ASSERT_FALSE(inliers.empty());
    std::cout << "image " << number << ": x " << observation.posture.X_FR.x() << " m, y "
              << observation.posture.X_FR.y() << " m, theta " << observation.posture.X_FR.theta()
              << " rad, inlier ratio " << observation.posture.inlier_ratio << ", median "
              << median(inliers) << " m, 90 % " << median(inliers, 0.9) << " m; of all points "
              << median(all) << " m, 90 % " << median(all, 0.9) << " m\n";
    EXPECT_LT(median(inliers), 0.06) << "image " << number;
    EXPECT_LT(median(all), 0.06) << "image " << number;
    EXPECT_GT(observation.posture.inlier_ratio, 0.6) << "image " << number;
  }
}

}  // namespace
}  // namespace teamsight
