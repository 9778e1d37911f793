// tests/vision/colour_classes_test.cpp: classes by discs, by a table, and in another light.
#include "vision/colour_classes.hpp"

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

ColourParameters green_and_ball() {
  ColourParameters parameters;
  parameters.white_min_y = 150;
  parameters.black_max_y = 40;
  parameters.samples = {{ColourClass::kGreen, 101, 94, 24}, {ColourClass::kBall, 61, 200, 30}};
  return parameters;
}

TEST(ColourClasses, AskATrainedTableInsteadOfTheDiscs) {
  ColourParameters parameters = green_and_ball();
  parameters.table.assign(kClassCells, ColourClass::kNone);
  parameters.table[class_cell({87, 101, 94})] = ColourClass::kBlue;

  const ColourClasses colours(parameters);

  EXPECT_EQ(colours.chromatic(87, {101, 94}), ColourClass::kBlue);
  EXPECT_EQ(colours.chromatic(139, {61, 200}), ColourClass::kNone);
  EXPECT_EQ(colours.of(200, {61, 200}), ColourClass::kWhite);
}

TEST(ColourClasses, TakeColoursBackToTheirOwnLight) {
  // The ball, red 240, green 110 and blue 20, in a light of half the red and more blue.
  const Chroma ball = chroma_of_bgr(26, 99, 120);
  const std::uint8_t y = luminance_of_bgr(26, 99, 120);
  ColourClasses colours(green_and_ball());
  ASSERT_EQ(colours.chromatic(y, ball), ColourClass::kNone);

  colours.adapt({0.5, 0.9, 1.3});

  const SampledColour restored = colours.restored(y, ball);
  EXPECT_NEAR(restored.y, 139, 1);
  EXPECT_NEAR(restored.u, 61, 1);
  EXPECT_NEAR(restored.v, 200, 1);
  EXPECT_EQ(colours.chromatic(y, ball), ColourClass::kBall);
}

TEST(ColourClasses, ComeBackUnchangedFromAnotherLight) {
  ColourClasses colours(green_and_ball());
  colours.adapt({1.5, 1.0, 0.6});

  colours.adapt({});

  EXPECT_EQ(colours.restored(87, {101, 94}), (SampledColour{87, 101, 94}));
  EXPECT_EQ(colours.exposure(), 1.0F);
}

}  // namespace
}  // namespace teamsight::vision
