// vision/radial_scan.cpp: reading the radial lines, and judging them against the carpet.
#include "vision/radial_scan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace teamsight::vision {

namespace {

// Shares of the carpet's own luminance beside the sample.
constexpr float kBlack = 0.56F;  // darker is dark whatever its colour: the mirror veils black green
constexpr float kDark = 0.72F;
constexpr float kVeiled = 0.7F;   // of the carpet's saturation
constexpr float kStrong = 0.25F;  // chroma over luminance
constexpr float kBright = 1.12F;
constexpr float kShade = 0.8F;             // as dark a carpet still counts for the running level
constexpr std::size_t kRealCarpet = 3;     // samples in a row
constexpr std::size_t kOffCarpet = 16;     // samples without carpet or paint: it has ended
constexpr std::size_t kLongestPaint = 60;  // samples; a line seen from its end
constexpr float kSheen = 1.2F;             // and as bright a one
constexpr float kForget = 0.12F;           // of the running level, per sample
constexpr float kLeastRise = 6.0F;         // grey levels of paint over carpet

/// One sample, and the carpet it is judged against.
struct Look {
  ColourClass colour{ColourClass::kNone};
  float y{0.0F};
  float chroma{0.0F};
  float carpet{0.0F};      // luminance of the carpet beside it
  float saturation{0.0F};  // of the frame's carpet: chroma over luminance
};

Surface surface_of(const Look& look) {
  const auto& [colour, y, chroma, carpet, saturation] = look;
  if (y < kBlack * carpet) return Surface::kDark;
  // A shadow on the carpet keeps its saturation, a robot's base that mirrors it does not.
  if (y < kDark * carpet && colour == ColourClass::kGreen && chroma < kVeiled * saturation * y) {
    return Surface::kDark;
  }
  switch (colour) {
    case ColourClass::kGreen:
      return Surface::kCarpet;
    case ColourClass::kBall:
      return Surface::kBall;
    case ColourClass::kRed:
    case ColourClass::kBlue:
    case ColourClass::kMagenta:
    case ColourClass::kCyan:
      // Not the coloured fringe of a bright line.
      if (chroma > kStrong * y && y < kBright * carpet + kLeastRise) return Surface::kShirt;
      break;
    default:
      break;
  }
  if (y < kDark * carpet) return Surface::kDark;
  // Over an overexposed carpet there is little room left.
  const float bright = std::min(kBright * carpet + kLeastRise, 0.5F * (carpet + 255.0F));
  return y > bright ? Surface::kPaint : Surface::kOther;
}

// Within 4 % of the Euclidean length.
std::uint8_t chroma_length(Chroma chroma) {
  const int du = std::abs(chroma.u - 128);
  const int dv = std::abs(chroma.v - 128);
  const int larger = std::max(du, dv);
  return static_cast<std::uint8_t>(larger + std::min(du, dv) * 3 / 8);
}

// The chroma in grey light as bright as the frame's.
Chroma without_cast(const SampledColour& restored, float exposure) {
  if (exposure == 1.0F) return {restored.u, restored.v};
  const auto brighter = [&](std::uint8_t value) {
    const float shown = 128.5F + exposure * static_cast<float>(value - 128);
    return static_cast<std::uint8_t>(std::clamp(shown, 0.0F, 255.0F));
  };
  return {brighter(restored.u), brighter(restored.v)};
}

}  // namespace

RadialScan::RadialScan(const ScanLines& lines, std::size_t chroma_window)
    : chroma_reader_(chroma_window, lines.longest()) {
  std::size_t size = 0;
  for (const ScanRange& range : lines.radial()) size = std::max(size, range.first + range.count);
  luminance_.resize(size);
  classes_.resize(size);
  chromas_.resize(size);
  surfaces_.resize(size);
  carpet_ends_.reserve(lines.radial().size());
}

void RadialScan::read(const PixelReader& pixels,
                      const ColourClasses& colours,
                      const ScanLines& lines) {
  meter_.clear();
  classify(pixels, colours, lines);
  carpet_ = meter_.carpet();
  carpet_ends_.clear();
  for (const ScanRange& range : lines.radial()) {
    judge(range);
    carpet_ends_.push_back(find_carpet_end(range));
  }
}

void RadialScan::classify(const PixelReader& pixels,
                          const ColourClasses& colours,
                          const ScanLines& lines) {
  for (const ScanRange& range : lines.radial()) {
    const auto taps = lines.taps(range);
    const auto luminance = std::span(luminance_).subspan(range.first, range.count);
    read_luminance(pixels, taps, luminance);
    const auto chroma = chroma_reader_.read(pixels, taps);
    for (std::size_t i = 0; i < range.count; ++i) {
      const SampledColour restored =
          colours.restored(static_cast<std::uint8_t>(luminance[i]), chroma[i]);
      const ColourClass colour = colours.of(restored);
      const Chroma uncast = without_cast(restored, colours.exposure());
      classes_[range.first + i] = colour;
      chromas_[range.first + i] = chroma_length(uncast);
      if (colour == ColourClass::kGreen) meter_.add_green(luminance[i], uncast);
    }
    meter_.add_samples(range.count);
  }
}

std::size_t RadialScan::find_carpet_end(const ScanRange& range) const {
  const auto surfaces = this->surfaces(range);
  std::size_t end = 0;
  std::size_t in_row = 0;
  std::size_t bare = 0;  // samples since the carpet that are neither paint nor ball
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    in_row = surfaces[i] == Surface::kCarpet ? in_row + 1 : 0;
    if (surfaces[i] != Surface::kPaint && surfaces[i] != Surface::kBall) ++bare;
    if (in_row >= kRealCarpet) {
      end = i + 1;
      bare = 0;
    }
    if (bare > kOffCarpet || i > end + kLongestPaint) break;
  }
  return end;
}

void RadialScan::judge(const ScanRange& range) {
  float level = carpet_.luminance;
  const float saturation = level > 0.0F ? std::hypot(carpet_.u, carpet_.v) / level : 0.0F;
  for (std::size_t i = range.first; i < range.first + range.count; ++i) {
    const float y = luminance_[i];
    surfaces_[i] = surface_of({classes_[i], y, static_cast<float>(chromas_[i]), level, saturation});
    const bool alike = y > kShade * level && y < kSheen * level;
    if (surfaces_[i] == Surface::kCarpet && alike) level += kForget * (y - level);
  }
}

}  // namespace teamsight::vision
