// tests/vision/ring_calibration_test.cpp: rings drawn at known radii are found again.
#include "vision/ring_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

constexpr std::uint32_t kSide = 400;
constexpr Pixel kCentre{203.0, 196.5};
const std::vector<double> kRadii{90.0, 112.0, 130.0, 143.0, 152.0};

std::vector<std::uint8_t> rings_picture(std::mt19937& random,
                                        const std::vector<double>& radii = kRadii) {
  std::normal_distribution<double> noise(0.0, 4.0);
  std::vector<std::uint8_t> bytes;
  for (std::uint32_t v = 0; v < kSide; ++v) {
    for (std::uint32_t u = 0; u < kSide; ++u) {
      const double radius = std::hypot(u - kCentre.u, v - kCentre.v);
      double y = 60.0;
      for (const double ring : radii)
        y += 120.0 * std::exp(-0.5 * std::pow((radius - ring) / 1.5, 2));
      // A strut from the middle downwards, three times as wide as the masked sector of the test.
      if (std::abs(u - kCentre.u) < 8.0 && v > kCentre.v) y = 10.0;
      bytes.push_back(static_cast<std::uint8_t>(std::clamp(y + noise(random), 0.0, 255.0)));
    }
  }
  return bytes;
}

RingRules rules() {
  RingRules rules;
  rules.centre = {200.0, 200.0};
  rules.distances = {1.0, 1.5, 2.0, 2.5, 3.0};
  rules.sectors = {{1.48 * std::numbers::pi, 1.52 * std::numbers::pi}};
  return rules;
}

TEST(RingCalibration, FindsCentreAndRadiiInSpiteOfAStrut) {
  std::mt19937 random(11);
  const auto bytes = rings_picture(random);

  const auto found = calibrate_rings({bytes, kSide, kSide, PixelFormat::kGrey}, rules());

  ASSERT_TRUE(found);
  EXPECT_FALSE(found->doubt);
  EXPECT_NEAR(found->centre.u, kCentre.u, 0.3);
  EXPECT_NEAR(found->centre.v, kCentre.v, 0.3);
  ASSERT_EQ(found->rings.size(), kRadii.size());
  for (std::size_t k = 0; k < kRadii.size(); ++k) {
    EXPECT_NEAR(found->rings[k].mark.radius_px, kRadii[k], 0.3);
    EXPECT_EQ(found->rings[k].mark.distance, rules().distances[k]);
    EXPECT_LT(found->rings[k].mark.sigma_px, 1.0);
  }
}

TEST(RingCalibration, NamesARingThatIsNone) {
  std::mt19937 random(12);
  std::vector<double> radii = kRadii;
  radii.insert(radii.begin(), 30.0);  // the robot's edge
  const auto bytes = rings_picture(random, radii);
  RingRules near_too = rules();
  near_too.inner_radius_px = 20.0;

  const auto found = calibrate_rings({bytes, kSide, kSide, PixelFormat::kGrey}, near_too);

  ASSERT_TRUE(found);
  ASSERT_TRUE(found->doubt);
  EXPECT_EQ(found->doubt->trouble, RingTrouble::kNoRing);
  EXPECT_EQ(found->doubt->ring, 0U);
}

TEST(RingCalibration, NamesADistanceWhoseRingIsNotThere) {
  std::mt19937 random(13);
  std::vector<double> radii = kRadii;
  radii.erase(radii.begin() + 1);
  const auto bytes = rings_picture(random, radii);

  const auto found = calibrate_rings({bytes, kSide, kSide, PixelFormat::kGrey}, rules());

  ASSERT_TRUE(found);
  ASSERT_TRUE(found->doubt);
  EXPECT_EQ(found->doubt->trouble, RingTrouble::kMissing);
  EXPECT_EQ(found->doubt->ring, 1U);
}

TEST(RingCalibration, SaysWhenThereAreNoRings) {
  const std::vector<std::uint8_t> flat(std::size_t{kSide} * kSide, 100);

  const auto found = calibrate_rings({flat, kSide, kSide, PixelFormat::kGrey}, rules());

  ASSERT_FALSE(found);
  EXPECT_EQ(found.error(), RingFailure::kTooFew);
  EXPECT_EQ(calibrate_rings({flat, kSide, 2 * kSide, PixelFormat::kGrey}, rules()).error(),
            RingFailure::kNotGrey);
}

}  // namespace
}  // namespace teamsight::vision
