// tests/vision/calibration/cube_training_test.cpp: planes between labelled colours.
#include "vision/calibration/cube_training.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "vision/colour_classes.hpp"
#include "vision/pixel_reader.hpp"

namespace teamsight::vision {
namespace {

// Pixels of a paint, with the noise of a camera, lit from half as bright to as bright as that.
std::vector<SampledColour> painted(int r, int g, int b, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 4.0);
  std::uniform_real_distribution<double> light(0.5, 1.0);
  std::vector<SampledColour> pixels;
  for (int i = 0; i < 400; ++i) {
    const double share = light(random);
    const auto lit = [&](int value) {
      return static_cast<int>(std::clamp(share * value + noise(random), 0.0, 255.0));
    };
    const int red = lit(r);
    const int green = lit(g);
    const int blue = lit(b);
    const Chroma chroma = chroma_of_bgr(blue, green, red);
    pixels.push_back({luminance_of_bgr(blue, green, red), chroma.u, chroma.v});
  }
  return pixels;
}

std::vector<LabelledColours> field_colours(unsigned seed) {
  return {{ColourClass::kGreen, painted(40, 120, 50, seed)},
          {ColourClass::kWhite, painted(235, 235, 225, seed)},
          {ColourClass::kBlack, painted(35, 35, 40, seed)},
          {ColourClass::kBall, painted(240, 110, 20, seed)},
          {ColourClass::kBlue, painted(40, 60, 220, seed)}};
}

double share_known(const ColourClasses& classes, const LabelledColours& place) {
  const auto known = std::ranges::count_if(place.pixels, [&](const SampledColour& p) {
    return classes.of(p.y, Chroma{p.u, p.v}) == place.colour;
  });
  return static_cast<double>(known) / static_cast<double>(place.pixels.size());
}

TEST(CubeTraining, PartsTheFieldsColoursInShadeAndLight) {
  ColourParameters parameters;
  parameters.method = ColourMethod::kCube;
  parameters.cube = train_cube(field_colours(1));
  ASSERT_TRUE(parameters.cube);

  const ColourClasses classes(parameters);

  for (const LabelledColours& place : field_colours(2)) {
    EXPECT_GT(share_known(classes, place), 0.97) << static_cast<int>(place.colour);
  }
}

TEST(CubeTraining, PutsTheBallWhereItsHueIsAndNoOtherClass) {
  auto places = field_colours(1);
  const auto alone = train_cube(places);
  places.push_back({ColourClass::kRed, painted(220, 20, 30, 1)});
  const auto beside_red = train_cube(places);

  ASSERT_TRUE(alone);
  ASSERT_TRUE(beside_red);
  EXPECT_EQ(alone->classes[1], ColourClass::kBall);  // red
  EXPECT_EQ(beside_red->classes[1], ColourClass::kRed);
  EXPECT_EQ(beside_red->classes[3], ColourClass::kBall);  // yellow
  EXPECT_EQ(beside_red->classes[6], ColourClass::kNone);  // nothing was cyan
}

TEST(CubeTraining, SaysNothingWithoutCarpetPaintOrBlack) {
  for (const ColourClass missing :
       {ColourClass::kGreen, ColourClass::kWhite, ColourClass::kBlack}) {
    auto places = field_colours(1);
    std::erase_if(places, [&](const LabelledColours& place) { return place.colour == missing; });

    EXPECT_FALSE(train_cube(places)) << static_cast<int>(missing);
  }
}

TEST(CubeTraining, LearnsWhatTheClassesSayOfAPicture) {
  CameraParameters camera;
  camera.width_px = 20;
  camera.height_px = 10;
  camera.mirror = RadialTable{9.5, 4.5, 0.7, {{0, 0}, {5, 1}, {20, 2}}};
  camera.mask.inner_radius_px = 2.0;
  camera.colours.samples = {{ColourClass::kGreen, 101, 94, 24}};
  std::vector<std::uint8_t> bytes;
  for (int pixel = 0; pixel < 200; ++pixel) {
    const bool is_left = pixel % 20 < 10;
    bytes.insert(bytes.end(),
                 {is_left ? std::uint8_t{50} : std::uint8_t{20},
                  is_left ? std::uint8_t{120} : std::uint8_t{20},
                  is_left ? std::uint8_t{40} : std::uint8_t{20}});
  }

  const auto places = labelled_by_classes({bytes, 20, 10, PixelFormat::kBgr}, camera);

  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].colour, ColourClass::kGreen);
  EXPECT_EQ(places[1].colour, ColourClass::kBlack);
  EXPECT_EQ(places[0].pixels.size(), places[1].pixels.size());
  EXPECT_EQ(places[0].pixels.size() + places[1].pixels.size(), 200U - 12U) << "all but the body";
}

}  // namespace
}  // namespace teamsight::vision
