// tests/vision/calibration/body_and_colours_test.cpp: masks from drawn sequences, classes from
// drawn colours.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "vision/calibration/body_mask.hpp"
#include "vision/calibration/colour_samples.hpp"

namespace teamsight::vision {
namespace {

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;
constexpr Pixel kCentre{160.0, 120.0};

struct Bgr {
  int b{0};
  int g{0};
  int r{0};
};

/// A picture of bytes, drawn pixel by pixel.
class Canvas {
 public:
  template <class Paint>
  explicit Canvas(const Paint& paint) {
    for (std::uint32_t v = 0; v < kHeight; ++v) {
      for (std::uint32_t u = 0; u < kWidth; ++u) {
        const Bgr colour = paint(u, v);
        for (const int channel : {colour.b, colour.g, colour.r}) {
          bytes_.push_back(static_cast<std::uint8_t>(std::clamp(channel, 0, 255)));
        }
      }
    }
  }

  [[nodiscard]] ImageView view() const { return {bytes_, kWidth, kHeight, PixelFormat::kBgr}; }

 private:
  std::vector<std::uint8_t> bytes_;
};

ColourParameters green_only() {
  ColourParameters colours;
  colours.samples = {{ColourClass::kGreen, 101, 94, 24}};
  return colours;
}

// A frame of a driving robot: body inside 30 px, a strut towards the right, stripes that move.
Canvas frame_of(int number, std::mt19937& random, bool is_driving = true) {
  std::normal_distribution<double> noise(0.0, 2.0);
  return Canvas([&](std::uint32_t u, std::uint32_t v) {
    const double du = u - kCentre.u;
    const double dv = v - kCentre.v;
    const bool is_body = std::hypot(du, dv) < 30.0 || (du > 0.0 && std::abs(dv) < 0.08 * du);
    const auto n = static_cast<int>(std::lround(noise(random)));
    if (is_body) return Bgr{20 + n, 20 + n, 20 + n};
    const int phase = static_cast<int>(u + v) + (is_driving ? 7 * number : 0);
    if (phase % 40 < 12) return Bgr{220 + n, 220 + n, 220 + n};
    return Bgr{40 + n, 120 + n, 40 + n};
  });
}

TEST(BodyWatch, FindsTheDiscAndTheStrut) {
  BodyWatch watch(kCentre, 116.0, kWidth, kHeight);
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) watch.add(frame_of(i, random).view());

  const auto body = watch.body(ColourClasses(green_only()));

  ASSERT_TRUE(body);
  EXPECT_NEAR(body->inner_radius_px, 28.0, 4.0);
  ASSERT_FALSE(body->patches.empty());
  for (const BodyPatch& patch : body->patches) {
    const double middle = std::remainder(0.5 * (patch.from + patch.to), 2.0 * std::numbers::pi);
    EXPECT_LT(std::abs(middle), 0.15);
    EXPECT_GT(patch.outer_px, 108.0);
    EXPECT_TRUE(patch.is_strut);
  }
}

TEST(BodyWatch, TakesAPatchThatHangsOverTheFloorForNoStrut) {
  BodyWatch watch(kCentre, 116.0, kWidth, kHeight);
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 2.0);
  for (int i = 0; i < 20; ++i) {
    const Canvas frame([&](std::uint32_t u, std::uint32_t v) {
      const bool is_body = std::hypot(u - kCentre.u, v - kCentre.v) < 30.0 ||
                           (u > 210 && u < 240 && v > 104 && v < 136);
      const auto n = static_cast<int>(std::lround(noise(random)));
      if (is_body) return Bgr{20 + n, 20 + n, 20 + n};
      const bool is_stripe = (static_cast<int>(u + v) + 7 * i) % 40 < 12;
      return is_stripe ? Bgr{220 + n, 220 + n, 220 + n} : Bgr{40 + n, 120 + n, 40 + n};
    });
    watch.add(frame.view());
  }

  const auto body = watch.body(ColourClasses(green_only()));

  ASSERT_TRUE(body);
  ASSERT_FALSE(body->patches.empty());
  for (const BodyPatch& patch : body->patches) {
    EXPECT_FALSE(patch.is_strut);
    EXPECT_GE(patch.inner_px, 44.0);
    EXPECT_LE(patch.outer_px, 88.0);
  }
}

TEST(BodyWatch, RefusesARobotThatStands) {
  BodyWatch watch(kCentre, 116.0, kWidth, kHeight);
  std::mt19937 random(2);
  const Canvas grey([](std::uint32_t, std::uint32_t) { return Bgr{90, 90, 90}; });
  for (int i = 0; i < 20; ++i) watch.add(grey.view());

  const auto body = watch.body(ColourClasses(green_only()));

  ASSERT_FALSE(body);
  EXPECT_EQ(body.error(), BodyFailure::kNotMoving);
}

TEST(BodyWatch, RefusesNineFrames) {
  BodyWatch watch(kCentre, 116.0, kWidth, kHeight);
  std::mt19937 random(3);
  for (int i = 0; i < 9; ++i) watch.add(frame_of(i, random).view());

  EXPECT_EQ(watch.body(ColourClasses(green_only())).error(), BodyFailure::kTooFew);
}

LabelledColours label(ColourClass colour, SampledColour middle) {
  LabelledColours result{colour, {}};
  for (int i = -3; i <= 3; ++i) {
    result.pixels.push_back({static_cast<std::uint8_t>(middle.y + i),
                             static_cast<std::uint8_t>(middle.u + i),
                             static_cast<std::uint8_t>(middle.v - i)});
  }
  return result;
}

TEST(ColourSamples, ReplacesWhatWasLabelledAndKeepsTheRest) {
  ColourParameters before = green_only();
  before.samples.push_back({ColourClass::kCyan, 163, 51, 30});

  const auto colours = colours_from(before,
                                    {label(ColourClass::kGreen, {80, 110, 100}),
                                     label(ColourClass::kWhite, {200, 128, 128}),
                                     label(ColourClass::kBall, {140, 60, 200})});

  ASSERT_TRUE(colours);
  ASSERT_EQ(colours->samples.size(), 1U);
  EXPECT_EQ(colours->samples[0], (ColourSample{ColourClass::kCyan, 163, 51, 30}));
  ASSERT_EQ(colours->sectors.size(), 2U);
  EXPECT_EQ(colours->sectors[0].colour, ColourClass::kGreen);
  EXPECT_EQ(colours->sectors[1].colour, ColourClass::kBall);
  EXPECT_NEAR(colours->white_min_y, 140, 4);
}

TEST(ColourSamples, KnowABallAgainInTheShadeAndInBrightLight) {
  const auto colours = colours_from({}, {label(ColourClass::kBall, {140, 80, 176})});

  ASSERT_TRUE(colours);
  const ColourClasses classes(*colours);
  EXPECT_EQ(classes.of(Chroma{104, 152}), ColourClass::kBall) << "half as vivid";
  EXPECT_EQ(classes.of(Chroma{56, 200}), ColourClass::kBall) << "half as vivid again";
  EXPECT_EQ(classes.of(Chroma{124, 132}), ColourClass::kNone) << "grey";
  EXPECT_EQ(classes.of(Chroma{128, 200}), ColourClass::kNone) << "red: 45 degrees off";
}

TEST(ColourSamples, PartColoursWhoseMarginsMeetHalfWayBetweenThem) {
  const LabelledColours red{ColourClass::kRed, {{90, 128, 178}}};
  const LabelledColours orange{ColourClass::kBall, {{140, 103, 171}}};  // 30 degrees on

  const auto colours = colours_from({}, {orange, red});

  ASSERT_TRUE(colours);
  const ColourClasses classes(*colours);
  EXPECT_EQ(classes.of(Chroma{118, 176}), ColourClass::kRed);   // 102 degrees
  EXPECT_EQ(classes.of(Chroma{113, 175}), ColourClass::kBall);  // 108 degrees
}

TEST(ColourSamples, HaveADiscOfAnotherClassLeaveOutWhatWasLabelled) {
  ColourParameters before = green_only();
  before.samples = {{ColourClass::kRed, 110, 180, 40}};

  const auto colours = colours_from(before, {label(ColourClass::kBall, {140, 90, 176})});

  ASSERT_TRUE(colours);
  const ColourClasses classes(*colours);
  EXPECT_EQ(classes.of(Chroma{90, 176}), ColourClass::kBall);
  EXPECT_EQ(classes.of(Chroma{110, 180}), ColourClass::kRed);
}

TEST(ColourSamples, MakeADiscOfAGreyBall) {
  const auto colours = colours_from({}, {label(ColourClass::kBall, {220, 128, 128})});

  ASSERT_TRUE(colours);
  EXPECT_TRUE(colours->sectors.empty());
  ASSERT_EQ(colours->samples.size(), 1U);
  EXPECT_EQ(ColourClasses(*colours).of(Chroma{127, 129}), ColourClass::kBall);
}

TEST(ColourSamples, RefusesClassesThatLookTheSame) {
  const auto colours = colours_from(green_only(), {label(ColourClass::kCyan, {90, 102, 95})});

  ASSERT_FALSE(colours);
  EXPECT_EQ(colours.error().a, ColourClass::kGreen);
  EXPECT_EQ(colours.error().b, ColourClass::kCyan);
}

// Carpet with lines, seen in light of this colour.
Canvas field_in_light(double blue, double green, double red) {
  return Canvas([=](std::uint32_t u, std::uint32_t v) {
    const bool is_line = (u + v) % 30 < 5;
    const Bgr paint = is_line ? Bgr{200, 200, 200} : Bgr{40, 120, 40};
    return Bgr{static_cast<int>(blue * paint.b),
               static_cast<int>(green * paint.g),
               static_cast<int>(red * paint.r)};
  });
}

TEST(FieldColours, FindsCarpetAndPaintInRedLight) {
  const Canvas picture = field_in_light(0.7, 1.0, 1.15);

  const auto found = field_colours(picture.view(), kCentre, 10.0, 58.0);

  ASSERT_TRUE(found);
  EXPECT_GT(found->white.v, 134);
  EXPECT_LT(found->white.u, 118);
  EXPECT_LT(found->green.v, 118);
}

TEST(FieldColours, CarriesTheBallIntoRedLight) {
  // What the ball looks like in that light, by hand.
  const auto seen = [](double blue, double green, double red) {
    const Canvas ball([=](std::uint32_t, std::uint32_t) {
      return Bgr{
          static_cast<int>(blue * 20), static_cast<int>(green * 110), static_cast<int>(red * 200)};
    });
    return colours_around(ball.view(), kCentre, 0.0).front();
  };
  const SampledColour before = seen(1.0, 1.0, 1.0);
  const SampledColour now = seen(0.7, 1.0, 1.15);
  ColourParameters colours = green_only();
  colours.samples.push_back({ColourClass::kBall, before.u, before.v, 20});
  const auto field = field_colours(field_in_light(0.7, 1.0, 1.15).view(), kCentre, 10.0, 58.0);
  ASSERT_TRUE(field);

  const ColourParameters carried = balanced(colours, *field);

  const auto off = [&](const ColourSample& sample) {
    return std::hypot(sample.u - now.u, sample.v - now.v);
  };
  EXPECT_LT(off(carried.samples[1]), 8.0);
  EXPECT_GT(off(colours.samples[1]), off(carried.samples[1]));
  EXPECT_EQ(carried.samples[0].u, field->green.u);
}

TEST(FieldColours, FindsNoneInAGreyRoom) {
  const Canvas room([](std::uint32_t u, std::uint32_t) {
    const int y = 60 + static_cast<int>(u) % 60;
    return Bgr{y, y, y};
  });

  EXPECT_FALSE(field_colours(room.view(), kCentre, 10.0, 58.0));
}

}  // namespace
}  // namespace teamsight::vision
