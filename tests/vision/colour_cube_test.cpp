// tests/vision/colour_cube_test.cpp: vertices of the RGB cube, one by one and many at once.
#include "vision/colour_cube.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "vision/pixel_reader.hpp"

namespace teamsight::vision {
namespace {

constexpr std::uint32_t kWidth = 14;  // no multiple of eight pixels
constexpr std::uint32_t kHeight = 10;

SampledColour colour_of(int r, int g, int b) {
  const Chroma chroma = chroma_of_bgr(b, g, r);
  return {luminance_of_bgr(b, g, r), chroma.u, chroma.v};
}

TEST(ColourCube, NamesTheEightVerticesOfPureColours) {
  const ColourCube cube(ColourCube::thresholds({128.0, 128.0, 128.0}));

  for (int vertex = 0; vertex < 8; ++vertex) {
    const int r = (vertex & 1) != 0 ? 230 : 30;
    const int g = (vertex & 2) != 0 ? 230 : 30;
    const int b = (vertex & 4) != 0 ? 230 : 30;

    EXPECT_EQ(cube.vertex(colour_of(r, g, b)), vertex);
    EXPECT_EQ(cube.vertex_of_bgr(static_cast<std::uint8_t>(b),
                                 static_cast<std::uint8_t>(g),
                                 static_cast<std::uint8_t>(r)),
              vertex);
  }
}

// A camera's own: white balance, crosstalk and thresholds, as three rows of (y, u, v, 1).
ColourCube::Transform some_transform(std::mt19937& random) {
  std::uniform_real_distribution<double> weight(-2.0, 2.0);
  std::uniform_real_distribution<double> middle(60.0, 200.0);
  ColourCube::Transform transform;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::RowVector3d weights{weight(random), weight(random), weight(random)};
    const Eigen::Vector3d at{middle(random), middle(random), middle(random)};
    transform.row(axis) << weights, -weights.dot(at);
  }
  return transform;
}

TEST(ColourCube, DividesWhereTheTransformSaysButForThreeGreyLevels) {
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    const ColourCube::Transform transform = some_transform(random);
    const ColourCube cube(transform);
    for (int i = 0; i < 400; ++i) {
      const SampledColour colour{static_cast<std::uint8_t>(random()),
                                 static_cast<std::uint8_t>(random()),
                                 static_cast<std::uint8_t>(random())};
      const Eigen::Vector4d channels(colour.y, colour.u, colour.v, 1.0);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const double value = transform.row(axis) * channels;
        if (std::abs(value) < 3.0 * transform.row(axis).head<3>().norm()) continue;
        EXPECT_EQ((cube.vertex(colour) >> axis & 1) != 0, value > 0.0);
      }
    }
  }
}

TEST(ColourCube, SegmentsAFrameOfAnyFormatAsItsPixelsOneByOne) {
  std::mt19937 random(12);
  for (const PixelFormat format : {PixelFormat::kYuyv,
                                   PixelFormat::kUyvy,
                                   PixelFormat::kBgr,
                                   PixelFormat::kNv12,
                                   PixelFormat::kBayerRggb}) {
    const ColourCube cube(some_transform(random));
    std::vector<std::uint8_t> bytes(frame_bytes(format, kWidth, kHeight));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    const ImageView image{bytes, kWidth, kHeight, format};
    std::vector<std::uint8_t> vertices(std::size_t{kWidth} * kHeight, 255);

    cube.segment(image, vertices);

    const PixelReader pixels(image);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Chroma chroma = pixels.chroma(i);
      const int expected =
          format == PixelFormat::kBgr
              ? cube.vertex_of_bgr(bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2])
              : cube.vertex({pixels.luminance(i), chroma.u, chroma.v});
      EXPECT_EQ(vertices[i], expected) << i;
    }
  }
}

}  // namespace
}  // namespace teamsight::vision
