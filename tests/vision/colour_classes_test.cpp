// tests/vision/colour_classes_test.cpp: classes by discs, a table or a cube, and in another light.
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

// Thresholds of 80 for each of red, green and blue; the yellow vertex is the ball, cyan is nothing.
ColourParameters cube_of_thresholds() {
  ColourParameters parameters = green_and_ball();
  parameters.cube =
      CubeParameters{{{{1.0, 0.0, 0.0, 80.0}, {0.0, 1.0, 0.0, 80.0}, {0.0, 0.0, 1.0, 80.0}}},
                     {ColourClass::kBlack,
                      ColourClass::kRed,
                      ColourClass::kGreen,
                      ColourClass::kBall,
                      ColourClass::kBlue,
                      ColourClass::kMagenta,
                      ColourClass::kNone,
                      ColourClass::kWhite}};
  parameters.method = ColourMethod::kCube;
  return parameters;
}

ColourClass class_of_bgr(const ColourClasses& colours, int b, int g, int r) {
  return colours.of(luminance_of_bgr(b, g, r), chroma_of_bgr(b, g, r));
}

TEST(ColourClasses, AskTheNearestVertexOfTheCubeInsteadOfTheDiscs) {
  const ColourClasses colours(cube_of_thresholds());

  EXPECT_EQ(class_of_bgr(colours, 20, 110, 240), ColourClass::kBall);
  EXPECT_EQ(class_of_bgr(colours, 40, 120, 40), ColourClass::kGreen);
  EXPECT_EQ(class_of_bgr(colours, 200, 40, 40), ColourClass::kBlue);
  EXPECT_EQ(class_of_bgr(colours, 200, 200, 40), ColourClass::kNone);
  EXPECT_EQ(class_of_bgr(colours, 20, 20, 20), ColourClass::kBlack);
  EXPECT_EQ(class_of_bgr(colours, 100, 100, 100), ColourClass::kWhite) << "whatever white_min_y is";
  EXPECT_EQ(colours.chromatic(100, {128, 128}), ColourClass::kNone);
  EXPECT_EQ(colours.chromatic(20, {128, 128}), ColourClass::kNone);
}

TEST(ColourClasses, AskTheMethodThatTheCameraFileSaysOfSeveral) {
  ColourParameters parameters = cube_of_thresholds();
  parameters.table.assign(kClassCells, ColourClass::kBlue);

  const ColourClasses by_cube(parameters);
  parameters.method = ColourMethod::kSamples;
  const ColourClasses by_samples(parameters);
  parameters.method.reset();
  const ColourClasses by_table(parameters);

  // As dark as the cube's black, of the ball's chroma.
  EXPECT_EQ(by_cube.of(20, {61, 200}), ColourClass::kRed);
  EXPECT_EQ(by_samples.of(20, {61, 200}), ColourClass::kBall);
  EXPECT_EQ(by_table.of(20, {61, 200}), ColourClass::kBlue);
}

TEST(ColourClasses, TakeColoursBackToTheCubesOwnLight) {
  ColourClasses colours(cube_of_thresholds());
  ASSERT_EQ(class_of_bgr(colours, 10, 55, 120), ColourClass::kRed);

  colours.adapt({0.5, 0.5, 0.5});

  EXPECT_EQ(class_of_bgr(colours, 10, 55, 120), ColourClass::kBall);
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

// Its blue would be brighter than can be shown: what is left of it looks yellow when taken back.
TEST(ColourClasses, TakeNoGlareForAColourInAnotherLight) {
  ColourParameters parameters;
  parameters.sectors = {{ColourClass::kBall, 2.5, 3.7, 12}};
  ColourClasses colours(parameters);
  colours.adapt({1.0, 1.0, 1.25});
  const auto shown = [&](int b, int g, int r) {
    return colours.chromatic(luminance_of_bgr(b, g, r), chroma_of_bgr(b, g, r));
  };

  EXPECT_EQ(shown(255, 230, 230), ColourClass::kNone);
  EXPECT_EQ(shown(120, 230, 255), ColourClass::kBall) << "yellow, its red in glare";
  EXPECT_EQ(shown(230, 230, 230), ColourClass::kBall) << "dim yellow in that light";
}

}  // namespace
}  // namespace teamsight::vision
