// tests/vision/calibration/class_training_test.cpp: what samples teach, and what they leave alone.
#include "vision/calibration/class_training.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "vision/colour_classes.hpp"

namespace teamsight::vision {
namespace {

// Pixels around a colour, with the noise of a camera.
std::vector<SampledColour> around(const SampledColour& middle) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 3.0);
  const auto noisy = [&](std::uint8_t value) {
    return static_cast<std::uint8_t>(value + std::lround(noise(random)));
  };
  std::vector<SampledColour> pixels;
  for (int i = 0; i < 300; ++i) {
    pixels.push_back({noisy(middle.y), noisy(middle.u), noisy(middle.v)});
  }
  return pixels;
}

ColourParameters one_disc() {
  ColourParameters parameters;
  parameters.samples = {{ColourClass::kGreen, 101, 94, 24}};
  return parameters;
}

ColourClasses trained(const std::vector<LabelledColours>& labels) {
  ColourParameters parameters = one_disc();
  parameters.table = train_classes(parameters, labels);
  return ColourClasses(parameters);
}

TEST(ClassTraining, TellsColoursOfOneChromaByTheirLuminance) {
  const ColourClasses colours = trained(
      {{ColourClass::kBall, around({160, 90, 180})}, {ColourClass::kRed, around({60, 90, 180})}});

  EXPECT_EQ(colours.of(SampledColour{160, 90, 180}), ColourClass::kBall);
  EXPECT_EQ(colours.of(SampledColour{60, 90, 180}), ColourClass::kRed);
  EXPECT_EQ(colours.of(SampledColour{152, 92, 176}), ColourClass::kBall);
}

TEST(ClassTraining, LeavesColoursWithoutSamplesAsTheyWere) {
  const ColourClasses colours = trained({{ColourClass::kBall, around({160, 90, 180})}});

  EXPECT_EQ(colours.of(SampledColour{87, 101, 94}), ColourClass::kGreen);
  EXPECT_EQ(colours.of(SampledColour{87, 200, 200}), ColourClass::kNone);
}

TEST(ClassTraining, TakesWhatIsWhiteOutOfTheClasses) {
  // Paint in a greenish light, within the carpet's disc.
  const ColourClasses colours = trained({{ColourClass::kWhite, around({210, 110, 108})}});

  EXPECT_EQ(colours.of(SampledColour{210, 110, 108}), ColourClass::kNone);
  EXPECT_EQ(colours.of(SampledColour{90, 110, 108}), ColourClass::kGreen);
}

TEST(ClassTraining, GoesOnFromATable) {
  ColourParameters parameters = one_disc();
  parameters.table = train_classes(parameters, {{ColourClass::kBall, around({160, 90, 180})}});

  parameters.table = train_classes(parameters, {{ColourClass::kBlue, around({80, 190, 110})}});

  const ColourClasses colours(parameters);
  EXPECT_EQ(colours.of(SampledColour{160, 90, 180}), ColourClass::kBall);
  EXPECT_EQ(colours.of(SampledColour{80, 190, 110}), ColourClass::kBlue);
}

}  // namespace
}  // namespace teamsight::vision
