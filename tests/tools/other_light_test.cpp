// tests/tools/other_light_test.cpp: what becomes of a picture's bytes in another light.
#include "tools/other_light.hpp"

#include <cmath>
#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace teamsight::tools {
namespace {

ImageFile grey_picture(std::uint8_t level) {
  constexpr std::uint32_t kSize = 64;
  return {std::vector<std::uint8_t>(3UL * kSize * kSize, level),
          kSize,
          kSize,
          vision::PixelFormat::kBgr};
}

TEST(OtherLight, MultipliesEachColourAndStopsAtTheBrightest) {
  ImageFile picture = grey_picture(100);
  picture.bytes[0] = 240;

  const ImageFile shown = in_light(picture, {"", {0.5, 1.0, 1.2}});

  EXPECT_EQ(shown.bytes[0], 255);
  EXPECT_EQ(shown.bytes[1], 100);
  EXPECT_EQ(shown.bytes[2], 50);
  EXPECT_EQ(shown.bytes[3], 120);
}

TEST(OtherLight, AddsNoiseOfThatSizeTheSameEachTime) {
  const ImageFile picture = grey_picture(100);
  const OtherLight noisy{"", {}, 5.0};

  const ImageFile shown = in_light(picture, noisy);

  double sum = 0.0;
  for (const std::uint8_t level : shown.bytes) sum += (level - 100.0) * (level - 100.0);
  EXPECT_NEAR(std::sqrt(sum / static_cast<double>(shown.bytes.size())), 5.0, 0.2);
  EXPECT_EQ(in_light(picture, noisy).bytes, shown.bytes);
}

TEST(OtherLight, BlursOverTheNearestPixelsOfTheSameColour) {
  ImageFile picture = grey_picture(0);
  const std::size_t middle = 3UL * (32 * picture.width_px + 32);
  picture.bytes[middle] = 160;

  const ImageFile shown = in_light(picture, {"", {}, 0.0, true});

  EXPECT_EQ(shown.bytes[middle], 40);
  EXPECT_EQ(shown.bytes[middle + 3], 20);
  EXPECT_EQ(shown.bytes[middle + 3UL * picture.width_px + 3], 10);
  EXPECT_EQ(shown.bytes[middle + 1], 0) << "another colour";
}

TEST(OtherLight, EachIsAnotherOne) {
  std::set<std::string_view> names;
  for (const OtherLight& light : other_lights()) {
    EXPECT_TRUE(names.insert(light.name).second) << light.name;
    if (light.is_blurred) continue;
    EXPECT_NE(in_light(grey_picture(100), light).bytes, grey_picture(100).bytes) << light.name;
  }
}

}  // namespace
}  // namespace teamsight::tools
