// vision/radial_scan.cpp: reading the radial lines, and judging them against the carpet.
#include "vision/radial_scan.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "vision/lanes.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kRealCarpet = 3;     // samples in a row
constexpr std::size_t kOffCarpet = 16;     // samples without carpet or paint: it has ended
constexpr std::size_t kLongestPaint = 60;  // samples; a line seen from its end

constexpr std::size_t kTogether = 8;  // samples whose chroma is measured at once

EightShorts absolute(const EightShorts& lanes) {
  const EightShorts sign = lanes < 0;
  return (lanes ^ sign) - sign;
}

static_assert(ChromaReader::kSpare >= kTogether);

// Distances from grey of kTogether chromas, within 4 % of the Euclidean length.
void measure_lengths(const Chroma* chromas, std::uint8_t* lengths) {
  const auto pairs = load_lanes<EightHalves>(chromas);
  const EightShorts du = absolute(std::bit_cast<EightShorts>(pairs & 0xFFU) - 128);
  const EightShorts dv = absolute(std::bit_cast<EightShorts>(pairs >> 8U) - 128);
  const EightShorts is_u = du > dv;
  const EightShorts larger = (du & is_u) | (dv & ~is_u);
  const EightShorts smaller = du + dv - larger;
  store_lanes(__builtin_convertvector(larger + (smaller * 3 >> 3), EightBytes), lengths);
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

/// One line: what was read of it, and what is made of that.
struct LineReading {
  std::span<const float> luminance;
  std::span<const Chroma> chroma;
  std::span<ColourClass> classes;
  std::span<std::uint8_t> chromas;  // longer by kTogether, which are written as well
};

// In the camera file's light: colours are what they seem.
void classify_as_read(const ColourClasses& colours, const LineReading& line, CarpetMeter& meter) {
  const std::size_t n = line.classes.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto y = static_cast<std::uint8_t>(line.luminance[i]);
    const Chroma chroma = line.chroma[i];
    const ColourClass colour = colours.of(SampledColour{y, chroma.u, chroma.v});
    line.classes[i] = colour;
    if (colour == ColourClass::kGreen) meter.add_green(y, chroma);
  }
  for (std::size_t i = 0; i < n; i += kTogether) {
    measure_lengths(line.chroma.data() + i, &line.chromas[i]);
  }
}

void classify_restored(const ColourClasses& colours, const LineReading& line, CarpetMeter& meter) {
  const std::size_t n = line.classes.size();
  const float exposure = colours.exposure();
  std::array<Chroma, kTogether> uncast{};
  for (std::size_t first = 0; first < n; first += kTogether) {
    for (std::size_t i = first; i < std::min(first + kTogether, n); ++i) {
      const auto y = static_cast<std::uint8_t>(line.luminance[i]);
      const SampledColour restored = colours.restored(y, line.chroma[i]);
      const ColourClass colour = colours.of(restored);
      const Chroma chroma = without_cast(restored, exposure);
      uncast[i - first] = chroma;
      line.classes[i] = colour;
      if (colour == ColourClass::kGreen) meter.add_green(y, chroma);
    }
    measure_lengths(uncast.data(), &line.chromas[first]);
  }
}

void classify_line(const ColourClasses& colours, const LineReading& line, CarpetMeter& meter) {
  if (colours.is_adapted()) {
    classify_restored(colours, line, meter);
  } else {
    classify_as_read(colours, line, meter);
  }
  meter.add_samples(line.classes.size());
}

}  // namespace

RadialScan::RadialScan(const ScanLines& lines, std::size_t chroma_window)
    : chroma_reader_(chroma_window, lines.longest()) {
  std::size_t size = 0;
  for (const ScanRange& range : lines.radial()) size = std::max(size, range.first + range.count);
  luminance_.resize(size);
  classes_.resize(size);
  chromas_.resize(size + kTogether);
  levels_.resize(size);
  surfaces_.resize(size);
  carpet_ends_.reserve(lines.radial().size());
}

void RadialScan::read(const PixelReader& pixels,
                      const ColourClasses& colours,
                      const ScanLines& lines) {
  classify(pixels, colours, lines);
  carpet_ = meter_.carpet();
  judge(lines);
  carpet_ends_.clear();
  for (const ScanRange& range : lines.radial()) carpet_ends_.push_back(find_carpet_end(range));
}

void RadialScan::classify(const PixelReader& pixels,
                          const ColourClasses& colours,
                          const ScanLines& lines) {
  CarpetMeter meter;  // on the stack its sums need not go through memory
  for (const ScanRange& range : lines.radial()) {
    const auto taps = lines.taps(range);
    const auto luminance = std::span(luminance_).subspan(range.first, range.count);
    read_luminance(pixels, taps, luminance);
    classify_line(colours,
                  {luminance,
                   chroma_reader_.read(pixels, lines.pixels(range)),
                   std::span(classes_).subspan(range.first, range.count),
                   std::span(chromas_).subspan(range.first, range.count + kTogether)},
                  meter);
  }
  meter_ = meter;
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
      // Most of a line is carpet that goes on.
      i += leading_eights(surfaces.subspan(i + 1), Surface::kCarpet);
      end = i + 1;
      bare = 0;
    }
    if (bare > kOffCarpet || i > end + kLongestPaint) break;
  }
  return end;
}

void RadialScan::judge(const ScanLines& lines) {
  const float level = carpet_.luminance;
  const float saturation = level > 0.0F ? std::hypot(carpet_.u, carpet_.v) / level : 0.0F;
  const ReadSamples samples{classes_, luminance_, std::span(chromas_).first(surfaces_.size())};
  follow_carpet(samples, lines.radial(), level, levels_);
  judge_surfaces(samples, levels_, saturation, surfaces_);
}

}  // namespace teamsight::vision
