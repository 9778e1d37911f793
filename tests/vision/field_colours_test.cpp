// tests/vision/field_colours_test.cpp: which of the floor's colours are carpet and paint.
#include "vision/field_colours.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

void add(std::vector<SampledColour>& floor, std::size_t count, const SampledColour& colour) {
  floor.insert(floor.end(), count, colour);
}

TEST(FieldColourMeter, FindsTheCarpetBesideALargerFloorOfWeakColour) {
  const SampledColour carpet{180, 146, 70};
  std::vector<SampledColour> floor;
  add(floor, 3000, carpet);
  add(floor, 5000, {60, 139, 121});  // bluish grey
  add(floor, 400, {240, 128, 128});

  const auto found = FieldColourMeter().measure(floor);

  ASSERT_TRUE(found);
  EXPECT_EQ(found->green, carpet);
}

TEST(FieldColourMeter, TakesCarpetInShadeAndInALampsLightForOneCarpet) {
  std::vector<SampledColour> floor;
  for (const std::uint8_t y : std::array<std::uint8_t, 5>{50, 100, 100, 150, 200}) {
    const auto chroma = static_cast<std::uint8_t>(128 - y * 3 / 10);
    add(floor, 1000, {y, 124, chroma});
  }
  add(floor, 200, {240, 130, 125});

  const auto found = FieldColourMeter().measure(floor);

  ASSERT_TRUE(found);
  EXPECT_EQ(found->green, (SampledColour{100, 124, 98}));
  EXPECT_EQ(found->white, (SampledColour{240, 130, 125})) << "the bright carpet is no paint";
}

TEST(FieldColourMeter, TellsPaintFromACarpetThatIsNearlyGrey) {
  std::vector<SampledColour> floor;
  add(floor, 3000, {103, 130, 117});
  add(floor, 300, {235, 126, 130});

  const auto found = FieldColourMeter().measure(floor);

  ASSERT_TRUE(found);
  EXPECT_EQ(found->white, (SampledColour{235, 126, 130}));
}

TEST(FieldColourMeter, SaysNothingOfAFloorWithoutCarpet) {
  std::vector<SampledColour> floor;
  add(floor, 3000, {100, 128, 128});
  add(floor, 300, {235, 128, 128});

  EXPECT_FALSE(FieldColourMeter().measure(floor));
}

}  // namespace
}  // namespace teamsight::vision
