// tests/vision/surface_test.cpp: what samples show, one by one and many at once.
#include "vision/surface.hpp"

#include <cstdint>
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
  const Samples samples(4003);
  std::vector<float> levels(4003);
  std::mt19937 random(4);
  for (float& level : levels) level = static_cast<float>(random() % 256);
  std::vector<Surface> surfaces(4003, Surface::kOther);

  judge_surfaces(samples.read(), levels, kSaturation, surfaces);

  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    EXPECT_EQ(surfaces[i],
              surface_of({samples.classes[i],
                          static_cast<float>(samples.luminance[i]),
                          distance_from_grey(samples.chroma[i]),
                          levels[i],
                          kSaturation}))
        << i;
  }
}

// A sample of carpet about as bright as the level pulls it by 4 percent of the way.
std::vector<float> levels_of(const Samples& samples, const ScanRange& line, float start) {
  std::vector<float> levels;
  float level = start;
  for (std::size_t i = line.first; i < line.first + line.count; ++i) {
    levels.push_back(level);
    const auto y = static_cast<float>(samples.luminance[i]);
    if (samples.classes[i] != ColourClass::kGreen) continue;
    if (y > 0.8F * level && y < 1.2F * level) level += 0.04F * (y - level);
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
    std::vector<float> levels(samples.classes.size());

    follow_carpet(samples.read(), lines, kCarpet, levels);

    for (const ScanRange& line : lines) {
      const auto begin = levels.begin() + static_cast<std::ptrdiff_t>(line.first);
      EXPECT_EQ(std::vector<float>(begin, begin + static_cast<std::ptrdiff_t>(line.count)),
                levels_of(samples, line, kCarpet));
    }
  }
}

}  // namespace
}  // namespace teamsight::vision
