// vision/line_finder.cpp: where samples rise as they do onto paint, and every pixel there.
#include "vision/line_finder.hpp"

#include <algorithm>

#include "vision/line_reader.hpp"

namespace teamsight::vision {

namespace {

constexpr double kRise = 0.55;        // of the contrast: so much of an edge one sample shows
constexpr std::size_t kMargin = 8;    // px beside an edge, in which floor and carpet are looked for
constexpr std::size_t kAcross = 2;    // samples over which an edge is seen
constexpr double kSubpixels = 256.0;  // of a tap

// Whether the profile rises onto paint right behind sample `i`.
bool is_rise(std::span<const float> y, std::size_t i, float least) {
  return std::max(y[i + 1], y[i + kAcross]) - y[i] >= least;
}

// A place between two samples.
SampleTap tap_between(const ScanSample& a, const ScanSample& b, float t, std::size_t width) {
  const float u = a.u + t * (b.u - a.u);
  const float v = a.v + t * (b.v - a.v);
  const auto column = static_cast<std::uint32_t>(u);
  const auto row = static_cast<std::uint32_t>(v);
  constexpr auto kParts = static_cast<float>(kSubpixels);
  return {row * static_cast<std::uint32_t>(width) + column,
          static_cast<std::uint8_t>(kParts * (u - static_cast<float>(column))),
          static_cast<std::uint8_t>(kParts * (v - static_cast<float>(row)))};
}

}  // namespace

LineFinder::LineFinder(std::size_t longest, const LineRules& rules)
    : rules_(rules),
      rise_(static_cast<float>(kRise * rules.min_contrast)),
      widest_(static_cast<float>(kWidestCrossing * rules.line_width)) {
  taps_.reserve(longest);
  luminance_.reserve(longest);
}

// From before a rise to where paint crossed at a slant would have ended, and a margin.
LineFinder::Stretch LineFinder::stretch_at(const SampledLine& line, std::size_t rise) const {
  const std::size_t margin = (kMargin + line.pitch - 1) / line.pitch;
  const ScanSample& start = line.samples[rise];
  const auto is_on_paint = [&](const ScanSample& sample) {
    const float x = sample.x - start.x;
    const float y = sample.y - start.y;
    return x * x + y * y < widest_ * widest_;
  };
  std::size_t end = rise + 1;
  while (end < line.samples.size() && is_on_paint(line.samples[end])) ++end;
  return {rise - std::min(rise, margin), std::min(end + kAcross + margin, line.samples.size())};
}

void LineFinder::look_closely(const ColouredFrame& frame,
                              const SampledLine& line,
                              const Stretch& stretch,
                              std::vector<LinePoint>& points) {
  if (stretch.end < stretch.first + 2) return;
  const auto samples = line.samples.subspan(stretch.first, stretch.end - stretch.first);
  const std::size_t width = frame.pixels.width();
  taps_.clear();
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    for (std::size_t k = 0; k < line.pitch; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(line.pitch);
      taps_.push_back(tap_between(samples[i], samples[i + 1], t, width));
    }
  }
  luminance_.resize(taps_.size());
  read_luminance(frame.pixels, taps_, luminance_);
  find_line_points(
      frame.pixels, frame.colours, {samples, taps_, luminance_, line.pitch}, rules_, points);
}

void LineFinder::find(const ColouredFrame& frame,
                      const SampledLine& line,
                      std::vector<LinePoint>& points) {
  if (line.pitch == 1) {
    find_line_points(frame.pixels,
                     frame.colours,
                     {line.samples, line.taps, line.luminance, line.pitch},
                     rules_,
                     points);
    return;
  }
  // Stretches that touch are one: paint is not cut where the last one would have ended.
  Stretch open;
  for (std::size_t i = 0; i + kAcross < line.samples.size(); ++i) {
    if (!is_rise(line.luminance, i, rise_)) continue;
    const Stretch next = stretch_at(line, i);
    if (next.first > open.end) {
      look_closely(frame, line, open, points);
      open.first = next.first;
    }
    open.end = next.end;
  }
  look_closely(frame, line, open, points);
}

}  // namespace teamsight::vision
