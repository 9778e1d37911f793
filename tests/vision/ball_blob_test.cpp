// tests/vision/ball_blob_test.cpp: how large a ball is by its blob, whole or half.
#include "vision/ball_blob.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

constexpr double kRadius = 0.08;   // rad
constexpr double kSpacing = 2e-3;  // rad, of the pixels

// A disc around a direction that looks down by half a radian, of which `shown` are the pixels.
template <class Shown>
BallBlob disc_of(Shown shown) {
  BallBlob blob;
  const auto steps = static_cast<int>(kRadius / kSpacing) + 1;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const double across = i * kSpacing;
      const double up = j * kSpacing;
      if (std::hypot(across, up) > kRadius || !shown(across, up)) continue;
      const Eigen::Vector3d direction{std::cos(0.5 - up) * std::cos(across / std::cos(0.5)),
                                      std::cos(0.5 - up) * std::sin(across / std::cos(0.5)),
                                      -std::sin(0.5 - up)};
      const double weight = kSpacing * kSpacing;
      ++blob.pixels;
      blob.solid_angle += weight;
      blob.sum_direction += weight * direction;
      blob.sum_square += weight * direction * direction.transpose();
    }
  }
  return blob;
}

TEST(BallBlob, FillsTheAngleOfItsDisc) {
  const BallBlob whole = disc_of([](double, double) { return true; });

  EXPECT_NEAR(angular_extent_of(whole), kRadius, 0.03 * kRadius);
  EXPECT_GT(roundness_of(whole), 0.95);
}

TEST(BallBlob, KeepsItsExtentWhenOneSideIsShadedOrHidden) {
  const BallBlob shaded = disc_of([](double, double up) { return up > 0.0; });
  const BallBlob beside = disc_of([](double across, double) { return across < 0.02; });

  EXPECT_NEAR(angular_extent_of(shaded), kRadius, 0.03 * kRadius);
  EXPECT_NEAR(angular_extent_of(beside), kRadius, 0.06 * kRadius);
  EXPECT_LT(roundness_of(shaded), 0.7);
}

}  // namespace
}  // namespace teamsight::vision
