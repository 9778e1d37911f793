// vision/radial_scan.cpp: reading the radial lines, and judging them against the carpet.
#include "vision/radial_scan.hpp"

#include <algorithm>
#include <cmath>

#include "vision/lanes.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kRealCarpet = 3;     // samples in a row
constexpr std::size_t kOffCarpet = 16;     // samples without carpet or paint: it has ended
constexpr std::size_t kLongestPaint = 60;  // samples; a line seen from its end

constexpr std::size_t kStride = 4;  // samples; the carpet is measured by thousands

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
  std::span<const std::uint8_t> luminance;
  std::span<const Chroma> chroma;
  std::span<ColourClass> classes;
  std::span<Chroma> uncast;
};

// In the camera file's light: colours are what they seem.
void classify_as_read(const ColourClasses& colours, const LineReading& line) {
  colours.classify(line.luminance, line.chroma, line.classes);
  std::copy(line.chroma.begin(), line.chroma.end(), line.uncast.begin());
}

void classify_restored(const ColourClasses& colours, const LineReading& line) {
  const float exposure = colours.exposure();
  for (std::size_t i = 0; i < line.classes.size(); ++i) {
    const SampledColour restored = colours.restored(line.luminance[i], line.chroma[i]);
    line.classes[i] = colours.of(restored);
    line.uncast[i] = without_cast(restored, exposure);
  }
}

void measure_carpet(const LineReading& line, CarpetMeter& meter) {
  for (std::size_t i = 0; i < line.classes.size(); i += kStride) {
    if (line.classes[i] == ColourClass::kGreen) meter.add_green(line.luminance[i], line.uncast[i]);
  }
  meter.add_samples((line.classes.size() + kStride - 1) / kStride);
}

}  // namespace

RadialScan::RadialScan(const ScanLines& lines, std::size_t chroma_window)
    : chroma_reader_(chroma_window, lines.longest()) {
  std::size_t size = 0;
  for (const ScanRange& range : lines.radial()) size = std::max(size, range.first + range.count);
  luminance_.resize(size);
  classes_.resize(size);
  chroma_.resize(size);
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
    const LineReading line{luminance,
                           chroma_reader_.read(pixels, lines.pixels(range)),
                           std::span(classes_).subspan(range.first, range.count),
                           std::span(chroma_).subspan(range.first, range.count)};
    if (colours.is_adapted()) {
      classify_restored(colours, line);
    } else {
      classify_as_read(colours, line);
    }
    measure_carpet(line, meter);
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

void RadialScan::take_for_ball(const ScanLines& lines, const Pixel& middle, double radius_px) {
  for (const ScanRange& range : lines.radial()) {
    const auto samples = lines.samples(range);
    const Eigen::Vector2d start(samples.front().u, samples.front().v);
    const Eigen::Vector2d way = Eigen::Vector2d(samples.back().u, samples.back().v) - start;
    const double length = way.norm();
    if (length <= 0.0) continue;
    const Eigen::Vector2d off = Eigen::Vector2d(middle.u, middle.v) - start;
    const double along = off.dot(way) / length;
    const double square = radius_px * radius_px - off.squaredNorm() + along * along;
    if (square <= 0.0 || along <= 0.0) continue;
    const double half = std::sqrt(square);
    const auto pitch = static_cast<double>(range.pitch);
    const auto place = [&](double px) {
      return static_cast<std::size_t>(
          std::clamp(px / pitch, 0.0, static_cast<double>(range.count)));
    };
    const auto first = surfaces_.begin() + static_cast<std::ptrdiff_t>(range.first);
    std::fill(first + static_cast<std::ptrdiff_t>(place(along - half)),
              first + static_cast<std::ptrdiff_t>(place(along + half + pitch)),
              Surface::kBall);
  }
}

void RadialScan::judge(const ScanLines& lines) {
  const float level = carpet_.luminance;
  const float saturation = level > 0.0F ? std::hypot(carpet_.u, carpet_.v) / level : 0.0F;
  const ReadSamples samples{classes_, luminance_, chroma_};
  follow_carpet(samples, lines.radial(), level, levels_);
  judge_surfaces(samples, levels_, saturation, surfaces_);
}

}  // namespace teamsight::vision
