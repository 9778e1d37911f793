// vision/line_finder.cpp: where samples rise as they do onto paint, and every pixel there.
#include "vision/line_finder.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "vision/lanes.hpp"
#include "vision/line_reader.hpp"

namespace teamsight::vision {

namespace {

constexpr double kRise = 0.55;      // of the contrast: so much of an edge one sample shows
constexpr std::size_t kMargin = 8;  // px beside an edge, in which floor and carpet are looked for
constexpr std::size_t kAcross = 2;  // samples over which an edge is seen

using Profile = std::span<const std::uint8_t>;

// Whether the profile rises onto paint right behind sample `i`.
bool is_rise(Profile y, std::size_t i, std::uint8_t least) {
  return std::max(y[i + 1], y[i + kAcross]) >= y[i] + least;
}

// The first such sample from `i` on; where there is none, one too near to the end for any.
std::size_t next_rise(Profile y, std::size_t i, std::uint8_t least) {
  for (; i + kAcross + sizeof(SixteenBytes) <= y.size(); i += sizeof(SixteenBytes)) {
    const auto here = load_lanes<SixteenBytes>(&y[i]);
    const SixteenBytes one = excess(load_lanes<SixteenBytes>(&y[i + 1]), here);
    const SixteenBytes two = excess(load_lanes<SixteenBytes>(&y[i + kAcross]), here);
    const std::uint32_t bits =
        bits_of(std::bit_cast<SixteenBytes>((one >= least) | (two >= least)));
    if (bits != 0) return i + static_cast<std::size_t>(std::countr_zero(bits));
  }
  while (i + kAcross < y.size() && !is_rise(y, i, least)) ++i;
  return i;
}

}  // namespace

LineFinder::LineFinder(std::size_t longest, const LineRules& rules)
    : rules_(rules),
      rise_(static_cast<std::uint8_t>(std::ceil(kRise * rules.min_contrast))),
      widest_(static_cast<float>(kWidestCrossing * rules.line_width)) {
  luminance_.reserve(longest);
}

// Where paint that begins with a rise would have ended, crossed at a slant; not before `known`, the
// end of what began before it.
std::size_t LineFinder::paint_end(const SampledLine& line,
                                  std::size_t rise,
                                  std::size_t known) const {
  const ScanSample& start = line.samples[rise];
  const auto is_on_paint = [&](const ScanSample& sample) {
    const float x = sample.x - start.x;
    const float y = sample.y - start.y;
    return x * x + y * y < widest_ * widest_;
  };
  std::size_t end = std::max(rise + 1, known);
  while (end < line.samples.size() && is_on_paint(line.samples[end])) ++end;
  return end;
}

void LineFinder::look_closely(const ColouredFrame& frame,
                              const SampledLine& line,
                              const Stretch& stretch,
                              std::vector<LinePoint>& points) {
  if (stretch.end < stretch.first + 2) return;
  const auto samples = line.samples.subspan(stretch.first, stretch.end - stretch.first);
  const auto taps =
      line.taps.subspan(stretch.first * line.pitch, (samples.size() - 1) * line.pitch);
  luminance_.resize(taps.size());
  read_luminance(frame.pixels, taps, luminance_);
  find_line_points(
      frame.pixels, frame.colours, {samples, taps, luminance_, line.pitch}, rules_, points);
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
  const std::size_t margin = (kMargin + line.pitch - 1) / line.pitch;
  const std::size_t n = line.samples.size();
  // Stretches that touch are one: paint is not cut where the last one would have ended.
  Stretch open;
  std::size_t end = 0;
  for (std::size_t i = next_rise(line.luminance, 0, rise_); i + kAcross < n;
       i = next_rise(line.luminance, i + 1, rise_)) {
    end = paint_end(line, i, end);
    const std::size_t first = i - std::min(i, margin);
    if (first > open.end) {
      look_closely(frame, line, open, points);
      open.first = first;
    }
    open.end = std::min(end + kAcross + margin, n);
  }
  look_closely(frame, line, open, points);
}

}  // namespace teamsight::vision
