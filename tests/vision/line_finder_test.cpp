// tests/vision/line_finder_test.cpp: what a coarse look leads to is what a close look finds.
#include "vision/line_finder.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "vision/line_reader.hpp"

namespace teamsight::vision {
namespace {

constexpr std::uint32_t kWidth = 400;
constexpr std::uint32_t kHeight = 2;
constexpr double kMetresPerPixel = 0.01;
constexpr double kGreenY = 87.0;

/// A straight look along a row of noisy carpet, 10 mm to the pixel.
class Row {
 public:
  Row() : bytes_(frame_bytes(PixelFormat::kYuyv, kWidth, kHeight)), luminance_(kWidth, kGreenY) {}

  /// `width` pixels of paint about `middle`, with edges that take two pixels.
  void paint(double middle, double width, double contrast) {
    for (std::size_t i = 0; i < luminance_.size(); ++i) {
      const double inside = 0.5 * width - std::abs(static_cast<double>(i) - middle);
      luminance_[i] += std::clamp(0.5 + 0.5 * inside, 0.0, 1.0) * contrast;
    }
  }

  /// What is found with samples that are `pitch` pixels apart.
  [[nodiscard]] std::vector<LinePoint> points(std::size_t pitch, double sigma = 0.0) {
    draw(sigma);
    std::vector<SampleTap> taps;  // of the samples
    std::vector<SampleTap> close_taps;
    std::vector<ScanSample> samples;
    for (std::uint32_t u = 0; u + 1 < kWidth; u += static_cast<std::uint32_t>(pitch)) {
      taps.push_back({u, 0, 0});
      for (std::uint32_t k = 0; k < pitch; ++k) close_taps.push_back({u + k, 0, 0});
      const auto x = static_cast<float>(1.0 + kMetresPerPixel * u);
      samples.push_back({static_cast<float>(u), 0.0F, x, 0.0F, 0.01F, 0.01F});
    }
    const PixelReader pixels({bytes_, kWidth, kHeight, PixelFormat::kYuyv});
    std::vector<std::uint8_t> read(taps.size());
    read_luminance(pixels, taps, read);
    ColourParameters colours;
    colours.white_min_y = 150;
    colours.samples = {{ColourClass::kGreen, 101, 94, 24}};
    const ColourClasses classes(colours);
    LineFinder finder(kWidth, {0.125, 18.0});
    std::vector<LinePoint> found;
    finder.find({pixels, classes}, {samples, close_taps, read, pitch}, found);
    return found;
  }

 private:
  void draw(double sigma) {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 1.0);
    for (std::size_t i = 0; i < bytes_.size(); i += 2) {
      const double y = luminance_[i / 2 % kWidth] + sigma * noise(random);
      bytes_[i] = static_cast<std::uint8_t>(std::clamp(std::round(y), 0.0, 255.0));
      bytes_[i + 1] = i % 4 == 0 ? 101 : 94;
    }
  }

  std::vector<std::uint8_t> bytes_;
  std::vector<double> luminance_;
};

TEST(LineFinder, FindsPaintWhereverItLiesBetweenTheSamples) {
  for (int i = 0; i < 159; ++i) {
    const double middle = 15.0 + 2.3 * i;
    Row row;
    row.paint(middle, 12.5, 60.0);

    for (const std::size_t pitch : {1U, 2U, 4U, 6U}) {
      const auto points = row.points(pitch);

      ASSERT_EQ(points.size(), 1U) << middle << " px, pitch " << pitch;
      EXPECT_NEAR(points[0].u_px, middle, 0.1);
      EXPECT_NEAR(points[0].p_R.x, 1.0 + kMetresPerPixel * middle, 0.1 * kMetresPerPixel);
    }
  }
}

TEST(LineFinder, FindsWhatACloseLookFindsInNoise) {
  Row row;
  for (const double middle : {40.0, 61.0, 150.3, 230.7, 344.1}) row.paint(middle, 12.5, 50.0);

  const auto close = row.points(1, 4.0);
  ASSERT_EQ(close.size(), 5U);
  for (const std::size_t pitch : {2U, 3U, 6U}) {
    const auto coarse = row.points(pitch, 4.0);

    ASSERT_EQ(coarse.size(), close.size()) << pitch;
    for (std::size_t i = 0; i < close.size(); ++i) {
      EXPECT_NEAR(coarse[i].u_px, close[i].u_px, 1e-3);
      EXPECT_NEAR(coarse[i].p_R.x, close[i].p_R.x, 1e-5);
    }
  }
}

TEST(LineFinder, TakesNoWallForPaint) {
  Row row;
  row.paint(380.0, 200.0, 100.0);

  EXPECT_TRUE(row.points(4).empty());
}

}  // namespace
}  // namespace teamsight::vision
