// tests/vision/pixel_reader_test.cpp: one picture in every format reads the same.
#include "vision/pixel_reader.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

constexpr std::uint32_t kWidth = 8;
constexpr std::uint32_t kHeight = 6;
constexpr std::size_t kMiddle = 2 * kWidth + 3;

// An evenly coloured mosaic; `red` and `blue` say which of (row, column) modulo 2 they are at.
std::vector<std::uint8_t> mosaic(std::size_t red_row, std::size_t red_column) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t v = 0; v < kHeight; ++v) {
    for (std::size_t u = 0; u < kWidth; ++u) {
      const bool in_red_row = v % 2 == red_row;
      const bool in_red_column = u % 2 == red_column;
      bytes.push_back(in_red_row && in_red_column ? 200 : !in_red_row && !in_red_column ? 40 : 90);
    }
  }
  return bytes;
}

TEST(PixelReader, ReadsTheColourOfEveryMosaicEverywhere) {
  const struct {
    PixelFormat format;
    std::size_t red_row;
    std::size_t red_column;
  } cases[] = {{PixelFormat::kBayerRggb, 0, 0},
               {PixelFormat::kBayerBggr, 1, 1},
               {PixelFormat::kBayerGrbg, 0, 1},
               {PixelFormat::kBayerGbrg, 1, 0}};

  for (const auto& test : cases) {
    const auto bytes = mosaic(test.red_row, test.red_column);
    const PixelReader reader({bytes, kWidth, kHeight, test.format});

    for (std::size_t pixel = 0; pixel < bytes.size(); ++pixel) {
      EXPECT_EQ(reader.luminance(pixel), luminance_of_bgr(40, 90, 200)) << pixel;
      EXPECT_EQ(reader.chroma(pixel), chroma_of_bgr(40, 90, 200)) << pixel;
    }
  }
}

TEST(PixelReader, FindsTheChromaOfAnNv12PixelBehindTheLuminance) {
  std::vector<std::uint8_t> bytes(kWidth * kHeight * 3 / 2, 77);
  const std::size_t pair = kWidth * kHeight + 2 / 2 * kWidth + 2;  // row 2, columns 2 and 3
  bytes[pair] = 100;
  bytes[pair + 1] = 150;
  const PixelReader reader({bytes, kWidth, kHeight, PixelFormat::kNv12});

  EXPECT_EQ(reader.luminance(kMiddle), 77);
  EXPECT_EQ(reader.chroma(kMiddle), (Chroma{100, 150}));
  EXPECT_EQ(reader.chroma(kMiddle + 1), (Chroma{77, 77}));
}

TEST(PixelReader, ReadsBothOrdersOfPackedPixels) {
  std::vector<std::uint8_t> yuyv;
  std::vector<std::uint8_t> uyvy;
  for (std::size_t i = 0; i < kWidth * kHeight / 2; ++i) {
    yuyv.insert(yuyv.end(), {10, 100, 20, 150});
    uyvy.insert(uyvy.end(), {100, 10, 150, 20});
  }
  const PixelReader one({yuyv, kWidth, kHeight, PixelFormat::kYuyv});
  const PixelReader other({uyvy, kWidth, kHeight, PixelFormat::kUyvy});

  for (const std::size_t pixel : {kMiddle, kMiddle + 1}) {
    EXPECT_EQ(one.luminance(pixel), pixel % 2 == 0 ? 10 : 20);
    EXPECT_EQ(other.luminance(pixel), one.luminance(pixel));
    EXPECT_EQ(one.chroma(pixel), (Chroma{100, 150}));
    EXPECT_EQ(other.chroma(pixel), one.chroma(pixel));
  }
}

TEST(ImageView, IsNotWholeInASizeItsFormatCannotHave) {
  const std::vector<std::uint8_t> bytes(7 * 5 * 3);

  EXPECT_TRUE(is_whole({bytes, 7, 5, PixelFormat::kBgr}));
  EXPECT_FALSE(is_whole({std::span(bytes).first(7 * 5 * 2), 7, 5, PixelFormat::kYuyv}));
  EXPECT_FALSE(is_whole({std::span(bytes).first(7 * 5), 7, 5, PixelFormat::kBayerRggb}));
  EXPECT_FALSE(is_whole({std::span(bytes).first(8 * 5), 8, 5, PixelFormat::kNv12}));
}

}  // namespace
}  // namespace teamsight::vision
