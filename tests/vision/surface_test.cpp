// tests/vision/surface_test.cpp: what samples show, one by one and many at once.
#include "vision/surface.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

constexpr float kCarpet = 90.0F;
constexpr float kSaturation = 0.4F;

Look look(ColourClass colour, float y, float chroma) {
  return {colour, y, chroma, kCarpet, kSaturation};
}

TEST(Surface, IsDarkOrBrightAgainstTheCarpetBesideIt) {
  EXPECT_EQ(surface_of(look(ColourClass::kNone, 20.0F, 5.0F)), Surface::kDark);
  EXPECT_EQ(surface_of(look(ColourClass::kNone, 85.0F, 5.0F)), Surface::kOther);
  EXPECT_EQ(surface_of(look(ColourClass::kNone, 200.0F, 5.0F)), Surface::kPaint);
  EXPECT_EQ(surface_of({ColourClass::kNone, 85.0F, 5.0F, 50.0F, kSaturation}), Surface::kPaint);
}

TEST(Surface, IsCarpetInAShadowButNotUnderAVeil) {
  EXPECT_EQ(surface_of(look(ColourClass::kGreen, 90.0F, 36.0F)), Surface::kCarpet);
  EXPECT_EQ(surface_of(look(ColourClass::kGreen, 60.0F, 24.0F)), Surface::kCarpet);
  EXPECT_EQ(surface_of(look(ColourClass::kGreen, 60.0F, 10.0F)), Surface::kDark);
}

TEST(Surface, IsAShirtOnlyInAStrongColourThatIsNoFringeOfPaint) {
  EXPECT_EQ(surface_of(look(ColourClass::kMagenta, 80.0F, 60.0F)), Surface::kShirt);
  EXPECT_EQ(surface_of(look(ColourClass::kMagenta, 80.0F, 10.0F)), Surface::kOther);
  EXPECT_EQ(surface_of(look(ColourClass::kMagenta, 200.0F, 60.0F)), Surface::kPaint);
}

/// Samples as no frame would have them: all surfaces, and values at the limits between them.
struct Samples {
  explicit Samples(std::size_t count) : classes(count), luminance(count), chroma(count) {
    std::mt19937 random(3);
    for (std::size_t i = 0; i < count; ++i) {
      classes[i] = static_cast<ColourClass>(random() % 10);
      if (random() % 3 != 0) classes[i] = ColourClass::kGreen;
      luminance[i] = static_cast<std::uint8_t>(random());
      const std::uint32_t spread = random() % 2 == 0 ? 256 : 40;
      chroma[i] = {static_cast<std::uint8_t>(128 - spread / 2 + random() % spread),
                   static_cast<std::uint8_t>(128 - spread / 2 + random() % spread)};
    }
  }

  [[nodiscard]] ReadSamples read() const { return {classes, luminance, chroma}; }

  std::vector<ColourClass> classes;
  std::vector<std::uint8_t> luminance;
  std::vector<Chroma> chroma;
};

TEST(Surface, IsTheSameForManySamplesAtOnce) {
  std::vector<CarpetLevel> levels(4003);
  std::mt19937 random(4);
  for (CarpetLevel& level : levels) level = static_cast<CarpetLevel>(random() % 256 * 128);
  // A stretch of carpet, as most of a picture is, and dark and bright places in it.
  Samples samples = Samples(4003);
  for (std::size_t i = 1000; i < 3000; ++i) {
    if (i % 97 != 0) samples.classes[i] = ColourClass::kGreen;
    levels[i] = static_cast<CarpetLevel>(90 * 128 + random() % 128);
    samples.luminance[i] =
        static_cast<std::uint8_t>(i % 83 == 0 ? 62 + random() % 6 : 80 + random() % 20);
  }
  std::vector<Surface> surfaces(4003, Surface::kOther);

  judge_surfaces(samples.read(), levels, kSaturation, surfaces);

  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    EXPECT_EQ(surfaces[i],
              surface_of({samples.classes[i],
                          static_cast<float>(samples.luminance[i]),
                          distance_from_grey(samples.chroma[i]),
                          static_cast<float>(levels[i]) / 128.0F,
                          kSaturation}))
        << i;
  }
}

// A sample of carpet about as bright as the level pulls it by 4 percent of the way, rounded to
// parts of a grey level.
std::vector<CarpetLevel> levels_of(const Samples& samples, const ScanRange& line, float start) {
  std::vector<CarpetLevel> levels;
  auto level = static_cast<int>(128.0F * start);
  for (std::size_t i = line.first; i < line.first + line.count; ++i) {
    levels.push_back(static_cast<CarpetLevel>(level));
    const int gap = 128 * samples.luminance[i] - level;
    if (samples.classes[i] != ColourClass::kGreen) continue;
    if (std::abs(gap) < level * 13107 / 65536) {
      level += static_cast<int>(std::floor((gap + 12) * 2621 / 65536.0));
    }
  }
  return levels;
}

TEST(CarpetLevel, FollowsEachLineByItselfHoweverManyThereAre) {
  const Samples samples(6000);
  std::mt19937 random(5);
  for (const std::size_t count : {1U, 7U, 8U, 19U}) {
    std::vector<ScanRange> lines;
    std::size_t first = 0;
    for (std::size_t i = 0; i < count; ++i) {
      lines.push_back({first, 1 + random() % 300, 0.0});
      first += lines.back().count;
    }
    std::vector<CarpetLevel> levels(samples.classes.size());

    follow_carpet(samples.read(), lines, kCarpet, levels);

    for (const ScanRange& line : lines) {
      const auto begin = levels.begin() + static_cast<std::ptrdiff_t>(line.first);
      EXPECT_EQ(std::vector<CarpetLevel>(begin, begin + static_cast<std::ptrdiff_t>(line.count)),
                levels_of(samples, line, kCarpet));
    }
  }
}

TEST(CarpetLevel, FollowsByFourPercentOfTheWay) {
  Samples samples(400);
  std::mt19937 random(6);
  for (std::size_t i = 0; i < 400; ++i) {
    samples.classes[i] = ColourClass::kGreen;
    samples.luminance[i] = static_cast<std::uint8_t>(80 + i / 8 + random() % 11);
  }
  std::vector<CarpetLevel> levels(400);

  follow_carpet(samples.read(), std::vector<ScanRange>{{0, 400, 0.0}}, kCarpet, levels);

  double level = kCarpet;
  for (std::size_t i = 0; i < 400; ++i) {
    EXPECT_NEAR(levels[i] / 128.0, level, 0.15) << i;
    level += 0.04 * (samples.luminance[i] - level);
  }
}

}  // namespace
}  // namespace teamsight::vision
