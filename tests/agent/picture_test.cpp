// tests/agent/picture_test.cpp: a frame as a small JPEG, read back by the library's decoder.
#include "agent/picture.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <turbojpeg.h>

#include "vision/pixel_reader.hpp"

namespace teamsight::agent {
namespace {

using vision::ImageView;
using vision::PixelFormat;

struct Bgr {
  int b{0};
  int g{0};
  int r{0};
};

/// The decoded pixel at a share of width and height.
Bgr pixel_of(const Picture& picture, double across, double down) {
  const int width = picture.width_px;
  const int height = picture.height_px;
  std::vector<unsigned char> bgr(std::size_t{3} * picture.width_px * picture.height_px);
  tjhandle decoder = tjInitDecompress();
  EXPECT_EQ(tjDecompress2(decoder,
                          picture.jpeg.data(),
                          picture.jpeg.size(),
                          bgr.data(),
                          width,
                          0,
                          height,
                          TJPF_BGR,
                          0),
            0);
  tjDestroy(decoder);
  const auto at = static_cast<std::size_t>(
      3 * (static_cast<int>(down * height) * width + static_cast<int>(across * width)));
  return {bgr[at], bgr[at + 1], bgr[at + 2]};
}

/// The left half orange, the right half blue.
std::vector<std::uint8_t> two_colours(std::uint32_t width, std::uint32_t height) {
  std::vector<std::uint8_t> bytes;
  for (std::uint32_t i = 0; i < width * height; ++i) {
    const bool is_left = i % width < width / 2;
    for (const int value : is_left ? std::array{20, 120, 240} : std::array{220, 80, 10}) {
      bytes.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return bytes;
}

TEST(PictureOf, ShowsAFramesColoursAtHalfItsSize) {
  const std::vector<std::uint8_t> bytes = two_colours(640, 480);

  const auto picture = picture_of({bytes, 640, 480, PixelFormat::kBgr});

  ASSERT_TRUE(picture.has_value());
  EXPECT_EQ(picture->width_px, 320);
  EXPECT_EQ(picture->height_px, 240);
  const Bgr left = pixel_of(*picture, 0.25, 0.5);
  const Bgr right = pixel_of(*picture, 0.75, 0.9);
  EXPECT_NEAR(left.b, 20, 12);
  EXPECT_NEAR(left.g, 120, 12);
  EXPECT_NEAR(left.r, 240, 12);
  EXPECT_NEAR(right.b, 220, 12);
  EXPECT_NEAR(right.r, 10, 12);
}

/// The same picture in a format with one chroma for a pair of pixels, or for four.
std::vector<std::uint8_t> in_format(PixelFormat format,
                                    const std::vector<std::uint8_t>& bgr,
                                    std::uint32_t width) {
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint8_t> chroma_plane;
  for (std::size_t i = 0; i + 5 < bgr.size(); i += 6) {
    const vision::Chroma chroma = vision::chroma_of_bgr(bgr[i], bgr[i + 1], bgr[i + 2]);
    const std::uint8_t y = vision::luminance_of_bgr(bgr[i], bgr[i + 1], bgr[i + 2]);
    const std::uint8_t z = vision::luminance_of_bgr(bgr[i + 3], bgr[i + 4], bgr[i + 5]);
    const bool is_even_row = i / 3 / width % 2 == 0;
    if (format == PixelFormat::kYuyv) bytes.insert(bytes.end(), {y, chroma.u, z, chroma.v});
    if (format == PixelFormat::kUyvy) bytes.insert(bytes.end(), {chroma.u, y, chroma.v, z});
    if (format == PixelFormat::kNv12) bytes.insert(bytes.end(), {y, z});
    if (is_even_row) chroma_plane.insert(chroma_plane.end(), {chroma.u, chroma.v});
  }
  if (format == PixelFormat::kNv12) {
    bytes.insert(bytes.end(), chroma_plane.begin(), chroma_plane.end());
  }
  return bytes;
}

class PictureIn : public ::testing::TestWithParam<PixelFormat> {};

TEST_P(PictureIn, ShowsTheSameColoursAsBgr) {
  const std::vector<std::uint8_t> bgr = two_colours(640, 480);
  const std::vector<std::uint8_t> bytes = in_format(GetParam(), bgr, 640);

  const auto picture = picture_of({bytes, 640, 480, GetParam()});
  const auto expected = picture_of({bgr, 640, 480, PixelFormat::kBgr});

  ASSERT_TRUE(picture && expected);
  EXPECT_EQ(picture->width_px, 320);
  EXPECT_EQ(picture->height_px, 240);
  for (const double across : {0.02, 0.25, 0.48, 0.52, 0.75, 0.98}) {
    const Bgr got = pixel_of(*picture, across, 0.9);
    const Bgr wanted = pixel_of(*expected, across, 0.9);
    EXPECT_NEAR(got.b, wanted.b, 3) << across;
    EXPECT_NEAR(got.g, wanted.g, 3) << across;
    EXPECT_NEAR(got.r, wanted.r, 3) << across;
  }
}

INSTANTIATE_TEST_SUITE_P(CameraFormats,
                         PictureIn,
                         ::testing::Values(PixelFormat::kYuyv,
                                           PixelFormat::kUyvy,
                                           PixelFormat::kNv12));

TEST(PictureOf, TakesTheCamerasOwnFormatsAndOddSizes) {
  const std::vector<std::uint8_t> yuyv(std::size_t{2} * 322 * 7, 128);
  const std::vector<std::uint8_t> grey(std::size_t{31} * 5, 90);
  const std::vector<std::uint8_t> bayer(std::size_t{1290} * 970, 60);

  const auto of_yuyv = picture_of({yuyv, 322, 7, PixelFormat::kYuyv});
  const auto of_grey = picture_of({grey, 31, 5, PixelFormat::kGrey});
  const auto of_bayer = picture_of({bayer, 1290, 970, PixelFormat::kBayerRggb});

  ASSERT_TRUE(of_yuyv && of_grey && of_bayer);
  EXPECT_EQ(of_yuyv->width_px, 161);
  EXPECT_EQ(of_yuyv->height_px, 3);
  EXPECT_EQ(of_grey->width_px, 31);
  EXPECT_NEAR(pixel_of(*of_grey, 0.5, 0.5).g, 90, 4);
  EXPECT_EQ(of_bayer->width_px, 258);
  EXPECT_NEAR(pixel_of(*of_bayer, 0.5, 0.5).r, 60, 4);
}

TEST(PictureOf, GivesNothingThatTheTopicCannotHold) {
  std::vector<std::uint8_t> noise(std::size_t{3} * 320 * 240);
  std::mt19937 random(7);  // NOLINT: a fixed seed is wanted
  for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>(random() & 0xFFU);

  EXPECT_FALSE(picture_of({noise, 320, 240, PixelFormat::kBgr}).has_value());
}

}  // namespace
}  // namespace teamsight::agent
