// tests/vision/localisation/localisation_consistency_test.cpp: the filter's covariance is true.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/vision/localisation/fields.hpp"
#include "tests/vision/localisation/ride.hpp"

namespace teamsight::vision {
namespace {

struct Figures {
  double nees{0.0};  // mean, per degree of freedom
  double rms{0.0};   // m
  int not_ok{0};
};

struct Scene {
  LocalisationParameters parameters;
  locate_score::DriveParameters drive;
  locate_score::LineViewParameters view;
  locate_score::MapFault fault;
  double lean_per_acceleration{0.0};
};

Figures measure(const Scene& scene, std::uint32_t first_seed) {
  constexpr int kRides = 8;
  constexpr int kFrames = 150;
  constexpr int kSettled = 15;
  Figures figures;
  int count = 0;
  for (std::uint32_t seed = first_seed; seed < first_seed + kRides; ++seed) {
    Ride ride(league_field(), scene.parameters, scene.drive, seed);
    ride.view = scene.view;
    ride.fault = scene.fault;
    ride.lean_per_acceleration = scene.lean_per_acceleration;
    ride.place_at_truth();
    for (int i = 0; i < kFrames; ++i) {
      const Located located = ride.frame();
      if (i < kSettled) continue;
      const Eigen::Vector3d error = ride.error(located);
      figures.nees += squared_mahalanobis(error, located.posture.cov) / 3.0;
      figures.rms += error.head<2>().squaredNorm();
      if (located.posture.status != PostureStatus::kOk) ++figures.not_ok;
      ++count;
    }
  }
  figures.nees /= count;
  figures.rms = std::sqrt(figures.rms / count);
  ::testing::Test::RecordProperty("nees_per_dof", std::to_string(figures.nees));
  ::testing::Test::RecordProperty("rms_m", std::to_string(figures.rms));
  return figures;
}

// A camera whose file is exactly right.
Scene noise_only() {
  Scene scene;
  scene.parameters.shared = {0.0, 1e-5, 1e-5};
  return scene;
}

// Successive errors of a filter are not independent, so the bounds are the goals', not chi
// square's.
void expect_consistent(const Figures& figures) {
  EXPECT_GT(figures.nees, 0.8);
  EXPECT_LT(figures.nees, 1.3);
  EXPECT_LE(figures.not_ok, 5);
}

TEST(LocalisationConsistency, HoldsUnderNoise) {
  const Figures figures = measure(noise_only(), 1);

  expect_consistent(figures);
  EXPECT_LT(figures.rms, 0.004);
}

TEST(LocalisationConsistency, HoldsUnderThirtyPercentOutliers) {
  Scene scene = noise_only();
  scene.view.outliers = 0.3;

  const Figures figures = measure(scene, 11);

  expect_consistent(figures);
  EXPECT_LT(figures.rms, 0.005);
}

TEST(LocalisationConsistency, HoldsWithAMapThatIsWrong) {
  Scene scene;
  scene.fault = {0.003, -0.002, 0.001, 0.001, 0.012};

  const Figures figures = measure(scene, 21);

  expect_consistent(figures);
  EXPECT_LT(figures.rms, 0.015);
}

TEST(LocalisationConsistency, HoldsForAHeadThatLeansUnderAcceleration) {
  Scene scene = noise_only();
  scene.lean_per_acceleration = 0.003;

  const Figures figures = measure(scene, 31);

  expect_consistent(figures);
}

TEST(LocalisationConsistency, HoldsWhileWheelsSlip) {
  Scene scene = noise_only();
  scene.drive.slips_per_second = 0.3;

  const Figures figures = measure(scene, 41);

  expect_consistent(figures);
  EXPECT_LT(figures.rms, 0.006);
}

}  // namespace
}  // namespace teamsight::vision
