// tests/vision/line_points_test.cpp: one scan line that crosses one painted line.
#include "vision/line_points.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

constexpr std::uint32_t kWidth = 64;
constexpr std::uint32_t kHeight = 2;
constexpr double kMetresPerPixel = 0.02;
constexpr std::uint8_t kGreenY = 87;

/// A straight look along a row of carpet, 20 mm to the pixel, one sample for each.
struct Look {
  Look() : bytes(frame_bytes(PixelFormat::kYuyv, kWidth, kHeight)) {
    for (std::size_t i = 0; i < bytes.size(); i += 4) {
      bytes[i] = bytes[i + 2] = kGreenY;
      bytes[i + 1] = 101;
      bytes[i + 3] = 94;
    }
    for (std::uint32_t u = 0; u + 1 < kWidth; ++u) {
      taps.push_back({u, 0, 0});
      const auto x = static_cast<float>(1.0 + kMetresPerPixel * u);
      samples.push_back({static_cast<float>(u), 0.0F, x, 0.0F, 0.02F, 0.02F});
    }
    luminance.assign(samples.size(), kGreenY);
  }

  // `width` pixels of paint about `middle`, edges that take two pixels.
  void paint(double middle, double width, double contrast) {
    for (std::size_t i = 0; i < luminance.size(); ++i) {
      const double inside = 0.5 * width - std::abs(static_cast<double>(i) - middle);
      const double covered = std::clamp(0.5 + 0.5 * inside, 0.0, 1.0);
      luminance[i] = static_cast<std::uint8_t>(std::lround(luminance[i] + covered * contrast));
    }
  }

  [[nodiscard]] std::vector<LinePoint> points() const {
    ColourParameters colours;
    colours.white_min_y = 150;
    colours.samples = {{ColourClass::kGreen, 101, 94, 24}};
    std::vector<LinePoint> found;
    find_line_points(PixelReader({bytes, kWidth, kHeight, PixelFormat::kYuyv}),
                     ColourClasses(colours),
                     {samples, taps, luminance},
                     {0.125, 18.0},
                     found);
    return found;
  }

  std::vector<std::uint8_t> bytes;
  std::vector<SampleTap> taps;
  std::vector<ScanSample> samples;
  std::vector<std::uint8_t> luminance;
};

TEST(LinePoints, AreFoundWhereverOnTheLineThePaintLies) {
  for (double middle = 9.0; middle < 53.0; middle += 0.25) {
    Look look;
    look.paint(middle, 6.25, 100.0);

    const auto points = look.points();

    ASSERT_EQ(points.size(), 1U) << middle;
    EXPECT_NEAR(points[0].u_px, middle, 0.1);
    EXPECT_NEAR(points[0].p_R.x, 1.0 + kMetresPerPixel * middle, 0.1 * kMetresPerPixel);
  }
}

TEST(LinePoints, AreTwoForTwoLinesBesideEachOther) {
  Look look;
  look.paint(20.0, 6.25, 100.0);
  look.paint(40.0, 6.25, 60.0);

  const auto points = look.points();

  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0].u_px, 20.0, 0.1);
  EXPECT_NEAR(points[1].u_px, 40.0, 0.1);
}

TEST(LinePoints, AreNoneOfWhatIsTooFaintOrNotAsWideAsPaint) {
  Look faint;
  faint.paint(30.0, 6.25, 15.0);
  Look wide;
  wide.paint(30.0, 16.0, 100.0);
  Look edge;
  edge.paint(60.0, 30.0, 100.0);

  EXPECT_TRUE(faint.points().empty());
  EXPECT_TRUE(wide.points().empty());
  EXPECT_TRUE(edge.points().empty());
}

}  // namespace
}  // namespace teamsight::vision
