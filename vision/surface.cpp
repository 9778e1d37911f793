// vision/surface.cpp: the carpet's running level, and surfaces against it, many samples at once.
#include "vision/surface.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "geometry/expect.hpp"
#include "vision/lanes.hpp"

namespace teamsight::vision {

namespace {

// Shares of the carpet's own luminance beside the sample.
constexpr float kBlack = 0.56F;  // darker is dark whatever its colour: the mirror veils black green
constexpr float kDark = 0.72F;
constexpr float kVeiled = 0.7F;   // of the carpet's saturation
constexpr float kStrong = 0.25F;  // chroma over luminance
constexpr float kBright = 1.12F;
constexpr float kLeastRise = 6.0F;    // grey levels of paint over carpet
constexpr float kSaturated = 255.0F;  // grey levels
constexpr std::uint32_t kAllBytes = 0xFFFF;

constexpr float kGreyOfLevel = 1.0F / kLevelsPerGrey;

constexpr int kShift = 16;     // of what follows
constexpr int kNear = 13107;   // 0.2: carpet no farther from the running level counts for it
constexpr int kForget = 2621;  // 0.04 of it, per sample: slower than a foot is blurred
constexpr int kRounding = 12;  // half of what moves the level by its smallest part
constexpr std::uint16_t kDarkPart = 47186;   // kDark, not less
constexpr std::uint16_t kBlackPart = 36700;  // kBlack, not more
constexpr std::uint16_t kBrightPart = 7864;  // kBright above 1, not more
constexpr std::int16_t kPaintRise = 768;     // kLeastRise as a level
constexpr std::int16_t kStrongest = 4;       // 1 over kStrong

constexpr std::size_t kTogether = 8;  // lines; what one waits for, the others fill

bool is_shirt_colour(ColourClass colour) {
  return colour == ColourClass::kRed || colour == ColourClass::kBlue ||
         colour == ColourClass::kMagenta || colour == ColourClass::kCyan;
}

// Luminance in the units of a level.
int level_of(std::uint8_t luminance) {
  return kLevelsPerGrey * luminance;
}

// The level behind a sample, from that before it.
int followed(int level, ColourClass colour, std::uint8_t luminance) {
  const int gap = level_of(luminance) - level;
  const int near = level * kNear >> kShift;
  const bool alike = gap > -near && gap < near;
  return colour == ColourClass::kGreen && alike ? level + ((gap + kRounding) * kForget >> kShift)
                                                : level;
}

EightShorts all_eight(int value) {
  return EightShorts{} + static_cast<std::int16_t>(value);
}

/// The running levels of eight lines beside each other: each waits for its last, but not for the
/// others.
class EightLevels {
 public:
  EightLevels(std::span<const ScanRange, kTogether> lines, int start) : level_(all_eight(start)) {
    for (std::size_t i = 0; i < kTogether; ++i) first_[i] = lines[i].first;
  }

  /// Eight samples of each line, `place` samples from its start.
  void follow(const ReadSamples& samples, std::size_t place, std::span<CarpetLevel> levels) {
    const auto green = [&](std::size_t line) {
      return green_from(samples, first_[line] + place);
    };
    const auto columns = columns_of(
        {green(0), green(1), green(2), green(3), green(4), green(5), green(6), green(7)});
    const EightRows before = transposed({pass(low_in_turns(SixteenBytes{}, columns[0])),
                                         pass(high_in_turns(SixteenBytes{}, columns[0])),
                                         pass(low_in_turns(SixteenBytes{}, columns[1])),
                                         pass(high_in_turns(SixteenBytes{}, columns[1])),
                                         pass(low_in_turns(SixteenBytes{}, columns[2])),
                                         pass(high_in_turns(SixteenBytes{}, columns[2])),
                                         pass(low_in_turns(SixteenBytes{}, columns[3])),
                                         pass(high_in_turns(SixteenBytes{}, columns[3]))});
    CarpetLevel* const to = &levels[place];
    store_lanes(before[0], to + first_[0]);
    store_lanes(before[1], to + first_[1]);
    store_lanes(before[2], to + first_[2]);
    store_lanes(before[3], to + first_[3]);
    store_lanes(before[4], to + first_[4]);
    store_lanes(before[5], to + first_[5]);
    store_lanes(before[6], to + first_[6]);
    store_lanes(before[7], to + first_[7]);
  }

  [[nodiscard]] int level(std::size_t line) const { return level_[line]; }

 private:
  // Luminance where the colour is the carpet's, else 0, which is like no carpet.
  static SixteenBytes green_from(const ReadSamples& samples, std::size_t first) {
    const auto is_green = std::bit_cast<SixteenBytes>(
        load_eight(&samples.classes[first]) ==
        SixteenBytes{} + static_cast<std::uint8_t>(ColourClass::kGreen));
    return is_green & load_eight(&samples.luminance[first]);
  }

  // The levels before a sample of each line, which they then follow.
  EightShorts pass(const SixteenBytes& green) {
    static_assert(kLevelsPerGrey == 128);  // half of what a byte is worth above another
    const EightShorts before = level_;
    const auto gap = std::bit_cast<EightShorts>(std::bit_cast<EightHalves>(green) >> 1) - before;
    const EightShorts near = high_products(before, all_eight(kNear));
    const EightShorts alike = (gap > -near) & (gap < near);
    level_ += alike & high_products(gap + kRounding, all_eight(kForget));
    return before;
  }

  std::array<std::size_t, kTogether> first_{};
  EightShorts level_;
};

// One sample after the other, from `place` on.
void follow_rest(const ReadSamples& samples,
                 const ScanRange& line,
                 std::size_t place,
                 int level,
                 std::span<CarpetLevel> levels) {
  for (std::size_t i = line.first + place; i < line.first + line.count; ++i) {
    levels[i] = static_cast<CarpetLevel>(level);
    level = followed(level, samples.classes[i], samples.luminance[i]);
  }
}

void follow_together(const ReadSamples& samples,
                     std::span<const ScanRange, kTogether> lines,
                     int start,
                     std::span<CarpetLevel> levels) {
  const std::size_t common = std::ranges::min_element(lines, {}, &ScanRange::count)->count;
  EightLevels eight(lines, start);
  std::size_t place = 0;
  for (; place + kTogether <= common; place += kTogether) eight.follow(samples, place, levels);
  for (std::size_t i = 0; i < kTogether; ++i) {
    follow_rest(samples, lines[i], place, eight.level(i), levels);
  }
}

// Whether sixteen samples are lit carpet, which no other question can make anything else.
bool are_all_carpet(const ReadSamples& samples,
                    std::span<const CarpetLevel> levels,
                    std::size_t first) {
  const auto y = load_lanes<SixteenBytes>(&samples.luminance[first]);
  const auto is_lit = [&](const SixteenBytes& above, std::size_t place) {
    const auto dark =
        high_products(load_lanes<EightHalves>(&levels[place]), EightHalves{} + kDarkPart);
    // Neither reaches the sign.
    const EightShorts here = std::bit_cast<EightShorts>(std::bit_cast<EightHalves>(above) >> 1);
    return std::bit_cast<SixteenBytes>(here > std::bit_cast<EightShorts>(dark));
  };
  const auto is_green =
      std::bit_cast<SixteenBytes>(load_lanes<SixteenBytes>(&samples.classes[first]) ==
                                  SixteenBytes{} + static_cast<std::uint8_t>(ColourClass::kGreen));
  const SixteenBytes low = is_lit(low_in_turns(SixteenBytes{}, y), first);
  const SixteenBytes high = is_lit(high_in_turns(SixteenBytes{}, y), first + kTogether);
  // All or not: whose lanes are which does not matter.
  return bits_of(low & high & is_green) == kAllBytes;
}

EightShorts absolute(const EightShorts& lanes) {
  const EightShorts sign = lanes < 0;
  return (lanes ^ sign) - sign;
}

// As distance_from_grey, of eight samples.
EightShorts distances_from_grey(const Chroma* chroma) {
  static_assert(sizeof(Chroma) == 2);
  const auto pairs = load_lanes<EightHalves>(chroma);
  const EightShorts du = absolute(std::bit_cast<EightShorts>(pairs & 0xFF) - 128);
  const EightShorts dv = absolute(std::bit_cast<EightShorts>(pairs >> 8) - 128);
  const EightShorts is_larger = du > dv;
  const EightShorts larger = (is_larger & du) | (~is_larger & dv);
  return larger + ((du + dv - larger) * 3 >> 3);
}

EightShorts part_of(const EightShorts& levels, std::uint16_t part) {
  return std::bit_cast<EightShorts>(
      high_products(std::bit_cast<EightHalves>(levels), EightHalves{} + part));
}

// The surface where the claim holds, else what was thought before.
EightShorts either(const EightShorts& claim, Surface surface, const EightShorts& before) {
  return (claim & all_eight(static_cast<int>(surface))) | (~claim & before);
}

// As surface_of, of eight samples; levels and parts are whole numbers, so claims are made such that
// rounding does not change them.
EightHalves surfaces_of(const ReadSamples& samples,
                        std::size_t first,
                        const CarpetLevel* levels,
                        std::uint16_t veiled) {
  const auto colours =
      std::bit_cast<EightShorts>(low_in_turns(load_eight(&samples.classes[first]), SixteenBytes{}));
  const auto is = [&](ColourClass colour) -> EightShorts {
    return colours == static_cast<std::int16_t>(colour);
  };
  const auto grey = std::bit_cast<EightShorts>(
      low_in_turns(load_eight(&samples.luminance[first]), SixteenBytes{}));
  const EightShorts y = grey << 7;
  const auto carpet = load_lanes<EightShorts>(levels);
  const EightShorts chroma = distances_from_grey(&samples.chroma[first]);
  const EightShorts rise = y - carpet;
  const EightHalves both = std::bit_cast<EightHalves>(carpet) + kLevelsPerGrey * 255;
  const EightShorts is_dark = ~(y > part_of(carpet, kDarkPart - 1));
  const EightShorts is_black = ~(y > part_of(carpet, kBlackPart));
  const EightShorts is_paint = (rise > part_of(carpet, kBrightPart + 1) + kPaintRise) |
                               (y > std::bit_cast<EightShorts>(both >> 1));
  const EightShorts is_strong = (is(ColourClass::kRed) | is(ColourClass::kBlue) |
                                 is(ColourClass::kMagenta) | is(ColourClass::kCyan)) &
                                (chroma * kStrongest > grey) &
                                ~(rise > part_of(carpet, kBrightPart) + kPaintRise);
  const EightShorts is_green = is(ColourClass::kGreen);
  const EightShorts is_veiled = is_green & is_dark & ((chroma << 6) < part_of(y, veiled));
  EightShorts surface =
      either(is_paint, Surface::kPaint, all_eight(static_cast<int>(Surface::kOther)));
  surface = either(is_dark, Surface::kDark, surface);
  surface = either(is_strong, Surface::kShirt, surface);
  surface = either(is(ColourClass::kBall), Surface::kBall, surface);
  surface = either(is_green, Surface::kCarpet, surface);
  return std::bit_cast<EightHalves>(either(is_black | is_veiled, Surface::kDark, surface));
}

}  // namespace

float distance_from_grey(Chroma chroma) {
  const int du = std::abs(chroma.u - 128);
  const int dv = std::abs(chroma.v - 128);
  return static_cast<float>(std::max(du, dv) + (std::min(du, dv) * 3 >> 3));
}

Surface surface_of(const Look& look) {
  const auto& [colour, y, chroma, carpet, saturation] = look;
  if (y < kBlack * carpet) return Surface::kDark;
  const bool is_green = colour == ColourClass::kGreen;
  // A shadow on the carpet keeps its saturation, a robot's base that mirrors it does not.
  if (y < kDark * carpet && is_green && chroma < kVeiled * saturation * y) return Surface::kDark;
  if (is_green) return Surface::kCarpet;
  if (colour == ColourClass::kBall) return Surface::kBall;
  const float paint = kBright * carpet + kLeastRise;
  // Not the coloured fringe of a bright line.
  if (is_shirt_colour(colour) && chroma > kStrong * y && y < paint) return Surface::kShirt;
  if (y < kDark * carpet) return Surface::kDark;
  // Over an overexposed carpet there is little room left.
  return y > std::min(paint, 0.5F * (carpet + kSaturated)) ? Surface::kPaint : Surface::kOther;
}

void follow_carpet(const ReadSamples& samples,
                   std::span<const ScanRange> lines,
                   float start,
                   std::span<CarpetLevel> levels) {
  const int first = static_cast<int>(std::lround(start * kLevelsPerGrey));
  while (lines.size() >= kTogether) {
    follow_together(samples, lines.first<kTogether>(), first, levels);
    lines = lines.subspan(kTogether);
  }
  for (const ScanRange& line : lines) follow_rest(samples, line, 0, first, levels);
}

void judge_surfaces(const ReadSamples& samples,
                    std::span<const CarpetLevel> levels,
                    float saturation,
                    std::span<Surface> surfaces) {
  const std::size_t n = surfaces.size();
  TEAMSIGHT_EXPECT(samples.classes.size() == n && samples.luminance.size() == n &&
                   samples.chroma.size() == n && levels.size() == n);
  // Half of the share of sixteen bits, for such as are more than all.
  const auto veiled = static_cast<std::uint16_t>(
      std::min(kVeiled * saturation * static_cast<float>(1 << (kShift - 1)), 65535.0F));
  std::size_t i = 0;
  for (; i + sizeof(SixteenBytes) <= n; i += sizeof(SixteenBytes)) {
    if (are_all_carpet(samples, levels, i)) {
      store_lanes(SixteenBytes{} + static_cast<std::uint8_t>(Surface::kCarpet), &surfaces[i]);
      continue;
    }
    store_lanes(to_bytes(surfaces_of(samples, i, &levels[i], veiled),
                         surfaces_of(samples, i + kTogether, &levels[i + kTogether], veiled)),
                &surfaces[i]);
  }
  for (; i < n; ++i) {
    surfaces[i] = surface_of({samples.classes[i],
                              static_cast<float>(samples.luminance[i]),
                              distance_from_grey(samples.chroma[i]),
                              static_cast<float>(levels[i]) * kGreyOfLevel,
                              saturation});
  }
}

}  // namespace teamsight::vision
