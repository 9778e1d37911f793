// vision/surface.cpp: the carpet's running level, and surfaces against it, four samples at once.
#include "vision/surface.hpp"

#include <algorithm>
#include <array>
#include <bit>
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
constexpr float kShade = 0.8F;    // as dark a carpet still counts for the running level
constexpr float kSheen = 1.2F;    // and as bright a one
constexpr float kForget = 0.04F;  // of the running level, per sample: slower than a foot is blurred
constexpr float kLeastRise = 6.0F;    // grey levels of paint over carpet
constexpr float kSaturated = 255.0F;  // grey levels
constexpr std::uint32_t kAllLanes = (1U << kLanes) - 1;

bool is_shirt_colour(ColourClass colour) {
  return colour == ColourClass::kRed || colour == ColourClass::kBlue ||
         colour == ColourClass::kMagenta || colour == ColourClass::kCyan;
}

// The level behind a sample, from that before it.
float followed(float level, ColourClass colour, float y) {
  const bool alike = y > kShade * level && y < kSheen * level;
  return colour == ColourClass::kGreen && alike ? level + kForget * (y - level) : level;
}

// Luminance where the colour is the carpet's, else 0, which is like no carpet.
FourFloats green_from(const ReadSamples& samples, std::size_t first) {
  const FourInts is_green =
      load_bytes(&samples.classes[first]) == static_cast<std::int32_t>(ColourClass::kGreen);
  return where(is_green, to_floats(load_bytes(&samples.luminance[first])), FourFloats{});
}

/// The running levels of four lines beside each other: each waits for its last, but not for the
/// others.
class FourLevels {
 public:
  FourLevels(std::span<const ScanRange, kLanes> lines, float start)
      : first_{lines[0].first, lines[1].first, lines[2].first, lines[3].first},
        level_{start, start, start, start} {}

  /// Four samples of each line, `place` samples from its start.
  void follow(const ReadSamples& samples, std::size_t place, std::span<float> levels) {
    FourFloats a = green_from(samples, first_[0] + place);
    FourFloats b = green_from(samples, first_[1] + place);
    FourFloats c = green_from(samples, first_[2] + place);
    FourFloats d = green_from(samples, first_[3] + place);
    transpose(a, b, c, d);
    a = pass(a);
    b = pass(b);
    c = pass(c);
    d = pass(d);
    transpose(a, b, c, d);
    store_lanes(a, &levels[first_[0] + place]);
    store_lanes(b, &levels[first_[1] + place]);
    store_lanes(c, &levels[first_[2] + place]);
    store_lanes(d, &levels[first_[3] + place]);
  }

  [[nodiscard]] float level(std::size_t line) const { return level_[line]; }

 private:
  // The levels before a sample of each line, which they then follow.
  FourFloats pass(const FourFloats& green) {
    const FourFloats before = level_;
    const FourInts alike = (green > kShade * before) & (green < kSheen * before);
    level_ += where(alike, kForget * (green - before), FourFloats{});
    return before;
  }

  std::array<std::size_t, kLanes> first_;
  FourFloats level_;
};

// One sample after the other, from `place` on.
void follow_rest(const ReadSamples& samples,
                 const ScanRange& line,
                 std::size_t place,
                 float level,
                 std::span<float> levels) {
  for (std::size_t i = line.first + place; i < line.first + line.count; ++i) {
    levels[i] = level;
    level = followed(level, samples.classes[i], static_cast<float>(samples.luminance[i]));
  }
}

// Two fours of lines at once: what one waits for, the other fills.
constexpr std::size_t kTogether = 2 * kLanes;

void follow_together(const ReadSamples& samples,
                     std::span<const ScanRange, kTogether> lines,
                     float start,
                     std::span<float> levels) {
  const std::size_t common = std::ranges::min_element(lines, {}, &ScanRange::count)->count;
  FourLevels one(lines.first<kLanes>(), start);
  FourLevels other(lines.last<kLanes>(), start);
  std::size_t place = 0;
  for (; place + kLanes <= common; place += kLanes) {
    one.follow(samples, place, levels);
    other.follow(samples, place, levels);
  }
  for (std::size_t i = 0; i < kLanes; ++i) {
    follow_rest(samples, lines[i], place, one.level(i), levels);
    follow_rest(samples, lines[kLanes + i], place, other.level(i), levels);
  }
}

// As surface_of, of four samples.
FourInts surfaces_of(const FourInts& colours,
                     const FourFloats& y,
                     const FourFloats& chroma,
                     const FourFloats& carpet,
                     float saturation) {
  const auto all = [](Surface surface) {
    const auto value = static_cast<std::int32_t>(surface);
    return FourInts{value, value, value, value};
  };
  const auto is = [&](ColourClass colour) -> FourInts {
    return colours == static_cast<std::int32_t>(colour);
  };
  const FourFloats paint = kBright * carpet + kLeastRise;
  const FourFloats room = 0.5F * (carpet + kSaturated);
  const FourInts is_green = is(ColourClass::kGreen);
  const FourInts is_dark = y < kDark * carpet;
  const FourInts is_strong = (is(ColourClass::kRed) | is(ColourClass::kBlue) |
                              is(ColourClass::kMagenta) | is(ColourClass::kCyan)) &
                             (chroma > kStrong * y) & (y < paint);
  const FourInts is_veiled = is_green & is_dark & (chroma < kVeiled * saturation * y);
  FourInts surface =
      where(y > where(paint < room, paint, room), all(Surface::kPaint), all(Surface::kOther));
  surface = where(is_dark, all(Surface::kDark), surface);
  surface = where(is_strong, all(Surface::kShirt), surface);
  surface = where(is(ColourClass::kBall), all(Surface::kBall), surface);
  surface = where(is_green, all(Surface::kCarpet), surface);
  return where((y < kBlack * carpet) | is_veiled, all(Surface::kDark), surface);
}

FourInts absolute(const FourInts& lanes) {
  const FourInts sign = lanes < 0;
  return (lanes ^ sign) - sign;
}

// As distance_from_grey, of four samples.
FourFloats distances_from_grey(const Chroma* chroma) {
  static_assert(sizeof(Chroma) == 2);
  const auto pairs =
      std::bit_cast<FourInts>(__builtin_convertvector(load_lanes<FourHalves>(chroma), FourWords));
  const FourInts du = absolute((pairs & 0xFF) - 128);
  const FourInts dv = absolute((pairs >> 8) - 128);
  const FourInts larger = where(du > dv, du, dv);
  return to_floats(larger + ((du + dv - larger) * 3 >> 3));
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
                   std::span<float> levels) {
  while (lines.size() >= kTogether) {
    follow_together(samples, lines.first<kTogether>(), start, levels);
    lines = lines.subspan(kTogether);
  }
  for (const ScanRange& line : lines) follow_rest(samples, line, 0, start, levels);
}

void judge_surfaces(const ReadSamples& samples,
                    std::span<const float> levels,
                    float saturation,
                    std::span<Surface> surfaces) {
  const std::size_t n = surfaces.size();
  TEAMSIGHT_EXPECT(samples.classes.size() == n && samples.luminance.size() == n &&
                   samples.chroma.size() == n && levels.size() == n);
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes) {
    const FourInts colours = load_bytes(&samples.classes[i]);
    const FourFloats y = to_floats(load_bytes(&samples.luminance[i]));
    const auto carpet = load_lanes<FourFloats>(&levels[i]);
    const FourInts is_lit = y >= kDark * carpet;
    const FourInts is_green = colours == static_cast<std::int32_t>(ColourClass::kGreen);
    // Most of a picture is carpet, which no other question can make anything else.
    if (bits_of(is_lit & is_green) == kAllLanes) {
      store_bytes(FourInts{} + static_cast<std::int32_t>(Surface::kCarpet), &surfaces[i]);
      continue;
    }
    const FourFloats chroma = distances_from_grey(&samples.chroma[i]);
    store_bytes(surfaces_of(colours, y, chroma, carpet, saturation), &surfaces[i]);
  }
  for (; i < n; ++i) {
    surfaces[i] = surface_of({samples.classes[i],
                              static_cast<float>(samples.luminance[i]),
                              distance_from_grey(samples.chroma[i]),
                              levels[i],
                              saturation});
  }
}

}  // namespace teamsight::vision
