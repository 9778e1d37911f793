// tests/vision/line_reader_test.cpp: many samples read at once are those read one by one.
#include "vision/line_reader.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

constexpr std::uint32_t kWidth = 22;
constexpr std::uint32_t kHeight = 14;

constexpr std::array kFormats{PixelFormat::kBgr,
                              PixelFormat::kYuyv,
                              PixelFormat::kUyvy,
                              PixelFormat::kGrey,
                              PixelFormat::kNv12,
                              PixelFormat::kBayerGrbg};

std::vector<std::uint8_t> noise(PixelFormat format, std::mt19937& random) {
  std::vector<std::uint8_t> bytes(frame_bytes(format, kWidth, kHeight));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

// Anywhere in the image, its last places as well.
std::vector<SampleTap> some_taps(std::size_t count, std::mt19937& random) {
  std::vector<SampleTap> taps(count);
  for (SampleTap& tap : taps) {
    tap.corner =
        static_cast<std::uint32_t>(random() % (kHeight - 1) * kWidth + random() % (kWidth - 1));
    tap.right = static_cast<std::uint8_t>(random());
    tap.below = static_cast<std::uint8_t>(random());
  }
  taps.back() = {(kHeight - 2) * kWidth + kWidth - 2, 255, 255};
  return taps;
}

std::vector<std::uint32_t> some_places(std::size_t count, std::mt19937& random) {
  std::vector<std::uint32_t> places(count);
  for (std::uint32_t& place : places) {
    place = static_cast<std::uint32_t>(random() % (kHeight * kWidth));
  }
  places.back() = kHeight * kWidth - 1;
  return places;
}

float bilinear(const PixelReader& pixels, const SampleTap& tap) {
  const auto y = [&](std::size_t pixel) {
    return 1.0 * pixels.luminance(pixel);
  };
  const double right = tap.right / 256.0;
  const double below = tap.below / 256.0;
  const double above = (1.0 - right) * y(tap.corner) + right * y(tap.corner + 1);
  const double under = (1.0 - right) * y(tap.corner + kWidth) + right * y(tap.corner + kWidth + 1);
  return static_cast<float>((1.0 - below) * above + below * under);
}

// Of single pixels around sample `i`; beyond its ends the line goes on as it ends.
Chroma mean_around(const PixelReader& pixels,
                   const std::vector<std::uint32_t>& places,
                   int i,
                   int window) {
  int u = 0;
  int v = 0;
  for (int k = i - window / 2; k <= i + window / 2; ++k) {
    const int last = static_cast<int>(places.size()) - 1;
    const Chroma chroma = pixels.chroma(places[static_cast<std::size_t>(std::clamp(k, 0, last))]);
    u += chroma.u;
    v += chroma.v;
  }
  return {static_cast<std::uint8_t>(u / window), static_cast<std::uint8_t>(v / window)};
}

TEST(LineReader, InterpolatesTheLuminanceOfEveryFormatToGreyLevels) {
  std::mt19937 random(1);
  for (const PixelFormat format : kFormats) {
    const auto bytes = noise(format, random);
    const PixelReader pixels({bytes, kWidth, kHeight, format});
    for (std::size_t count = 1; count < 14; ++count) {
      const auto taps = some_taps(count, random);
      std::vector<std::uint8_t> luminance(count);

      read_luminance(pixels, taps, luminance);

      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_NEAR(luminance[i], bilinear(pixels, taps[i]), 0.51) << count << " samples, " << i;
      }
    }
  }
}

TEST(LineReader, AveragesTheChromaOfEveryFormatOverItsWindow) {
  std::mt19937 random(2);
  for (const PixelFormat format : kFormats) {
    const auto bytes = noise(format, random);
    const PixelReader pixels({bytes, kWidth, kHeight, format});
    for (const int window : {1, 3, 9, 127}) {
      ChromaReader reader(static_cast<std::size_t>(window), 70);
      for (const std::size_t count : {1U, 6U, 70U}) {
        const auto places = some_places(count, random);

        const auto means = reader.read(pixels, places);

        ASSERT_EQ(means.size(), count);
        for (std::size_t i = 0; i < count; ++i) {
          EXPECT_EQ(means[i], mean_around(pixels, places, static_cast<int>(i), window)) << i;
        }
      }
    }
  }
}

TEST(LineReader, RoundsMeansDownAtTheirExtremes) {
  // All 255, and one of them 254: the widest window's sums are the hardest to divide.
  std::vector<std::uint8_t> bytes(frame_bytes(PixelFormat::kYuyv, kWidth, kHeight), 255);
  ChromaReader reader(127, 200);
  std::vector<std::uint32_t> places(200, 2 * kWidth);
  places[100] = 0;
  bytes[1] = 254;

  const auto means = reader.read(PixelReader({bytes, kWidth, kHeight, PixelFormat::kYuyv}), places);

  EXPECT_EQ(means[20], (Chroma{255, 255}));
  EXPECT_EQ(means[100], (Chroma{254, 255}));
}

}  // namespace
}  // namespace teamsight::vision
