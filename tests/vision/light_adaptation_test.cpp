// tests/vision/light_adaptation_test.cpp: what counts as another light, and what does not.
#include "vision/light_adaptation.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

constexpr double kStep = 0.2;  // s
const FieldColours kField{{87, 101, 94}, {200, 128, 128}};

// A colour in another light.
SampledColour in_light(const SampledColour& colour, const LightGains& gains) {
  const Eigen::Vector3d rgb = rgb_of(colour.y, colour.u, colour.v)
                                  .cwiseProduct(Eigen::Vector3d(gains.red, gains.green, gains.blue))
                                  .cwiseMax(0.0)
                                  .cwiseMin(255.0);
  const Eigen::Vector3d yuv = yuv_from_rgb() * rgb;
  const auto byte = [](double value) {
    return static_cast<std::uint8_t>(std::lround(value));
  };
  return {byte(yuv.x()), byte(128.0 + yuv.y()), byte(128.0 + yuv.z())};
}

FieldColours field_in(const LightGains& gains) {
  return {in_light(kField.green, gains), in_light(kField.white, gains)};
}

void take_for(LightAdaptation& adaptation, double seconds, const std::optional<FieldColours>& now) {
  const auto steps = static_cast<int>(std::lround(seconds / kStep));
  for (int i = 0; i < steps; ++i) adaptation.take(now, kStep);
}

void expect_near(const LightGains& gains, const LightGains& expected) {
  EXPECT_NEAR(gains.red, expected.red, 0.03);
  EXPECT_NEAR(gains.green, expected.green, 0.03);
  EXPECT_NEAR(gains.blue, expected.blue, 0.03);
}

TEST(LightAdaptation, FindsTheGainsOfAnotherLightAndComesBack) {
  const LightGains evening{0.9, 0.7, 0.5};
  LightAdaptation adaptation(kField);

  take_for(adaptation, 4.0, field_in(evening));

  expect_near(adaptation.state().gains, evening);
  EXPECT_EQ(adaptation.state().status, LightStatus::kFollowing);
  EXPECT_GT(adaptation.state().confidence, 0.8);

  take_for(adaptation, 4.0, kField);

  expect_near(adaptation.state().gains, {});
}

TEST(LightAdaptation, DoesNothingWithoutAReference) {
  LightAdaptation adaptation(std::nullopt);

  take_for(adaptation, 4.0, field_in({0.9, 0.7, 0.5}));

  EXPECT_EQ(adaptation.state(), LightState{});
}

TEST(LightAdaptation, StaysAtItsBoundAndSaysSo) {
  const LightRules rules;
  LightAdaptation adaptation(kField, rules);

  take_for(adaptation, 4.0, field_in({1.2, 0.5, 0.3}));

  const LightGains& gains = adaptation.state().gains;
  EXPECT_EQ(adaptation.state().status, LightStatus::kAtBound);
  EXPECT_NEAR(gains.red / gains.blue, rules.most_cast * rules.most_cast, 0.01);
  EXPECT_LT(adaptation.state().confidence, 0.1);
}

TEST(LightAdaptation, DoesNotTakeAnotherCarpetForAnotherLight) {
  FieldColours blue_carpet = kField;
  blue_carpet.green = {70, 160, 100};
  LightAdaptation adaptation(kField);
  take_for(adaptation, 2.0, kField);

  take_for(adaptation, 4.0, blue_carpet);

  EXPECT_EQ(adaptation.state().status, LightStatus::kDisputed);
  expect_near(adaptation.state().gains, {});
}

TEST(LightAdaptation, KeepsItsGainsWhileNothingIsSeen) {
  const LightGains evening{0.9, 0.7, 0.5};
  LightAdaptation adaptation(kField);
  take_for(adaptation, 4.0, field_in(evening));

  take_for(adaptation, 10.0, std::nullopt);

  EXPECT_EQ(adaptation.state().status, LightStatus::kWaiting);
  EXPECT_LT(adaptation.state().confidence, 0.1);
  expect_near(adaptation.state().gains, evening);
}

// Shade, and how much of what is in view, differ as much from picture to picture.
TEST(LightAdaptation, TakesALittleForNoOtherLight) {
  LightAdaptation adaptation(kField);

  take_for(adaptation, 4.0, field_in({1.04, 1.0, 0.97}));

  const LightGains& gains = adaptation.state().gains;
  EXPECT_EQ(adaptation.state().status, LightStatus::kFollowing);
  EXPECT_NEAR(gains.red, 1.0, 0.01);
  EXPECT_NEAR(gains.green, 1.0, 0.01);
  EXPECT_NEAR(gains.blue, 1.0, 0.01);
}

TEST(LightAdaptation, AsksTheCarpetAloneWherePaintWasSaturated) {
  FieldColours glare = kField;
  glare.white = {255, 128, 128};
  const LightGains evening{0.9, 0.7, 0.5};
  LightAdaptation adaptation(glare);

  take_for(adaptation, 4.0, field_in(evening));

  expect_near(adaptation.state().gains, evening);
}

TEST(LightAdaptation, TakesSaturatedPaintForNoEvidence) {
  const LightGains glare{1.6, 1.6, 1.6};  // paint of 200 would be 320
  LightAdaptation adaptation(kField);

  take_for(adaptation, 4.0, field_in(glare));

  expect_near(adaptation.state().gains, glare);
}

}  // namespace
}  // namespace teamsight::vision
