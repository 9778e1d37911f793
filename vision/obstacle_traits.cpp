// vision/obstacle_traits.cpp: shares of surfaces above, before and beside a foot.
#include "vision/obstacle_traits.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace teamsight::vision {

namespace {

constexpr double kPixels = 20.0;      // that lengths in the image are counted in
constexpr double kMostPixels = 40.0;  // more say no more
constexpr double kLow = 1.4;          // of the foot's distance: there a low thing ends
constexpr double kHigh = 2.5;         // of it: there a waist-high thing ends
constexpr std::size_t kBlur = 2;      // samples at the foot that are neither
constexpr std::size_t kFewestInZone = 4;
constexpr std::size_t kMostInZone = 40;
constexpr std::size_t kAbove = 10;  // samples beside it
constexpr std::size_t kFlankLines = 4;
constexpr double kNarrowest = 0.02;  // m; a single line
constexpr double kRough = 5.0;       // px

/// Counts of surfaces.
struct Tally {
  double all{0.0};
  double shirt{0.0};
  double dark{0.0};
  double floor{0.0};
  double carpet{0.0};

  [[nodiscard]] double share(double part) const { return all > 0.0 ? part / all : 0.0; }
};

/// One line of a scan.
struct Line {
  std::span<const ScanSample> samples;
  std::span<const Surface> surfaces;
};

Line line_of(const TraitSource& source, std::size_t index) {
  const ScanRange& range = source.lines.radial()[index];
  return {source.lines.samples(range), source.scan.surfaces(range)};
}

void count(const Line& line, std::size_t first, std::size_t last, Tally& tally) {
  for (std::size_t i = first; i < std::min(last, line.surfaces.size()); ++i) {
    const Surface surface = line.surfaces[i];
    tally.all += 1.0;
    if (surface == Surface::kShirt) tally.shirt += 1.0;
    if (surface == Surface::kDark) tally.dark += 1.0;
    if (surface == Surface::kCarpet) tally.carpet += 1.0;
    if (surface == Surface::kCarpet || surface == Surface::kPaint) tally.floor += 1.0;
  }
}

// The first sample from `first` on that is farther than `distance`, within the zone's limits.
std::size_t zone_end(const Line& line, std::size_t first, double distance) {
  std::size_t i = first;
  while (i < line.samples.size() && i - first < kMostInZone &&
         (i - first < kFewestInZone ||
          static_cast<double>(std::hypot(line.samples[i].x, line.samples[i].y)) < distance)) {
    ++i;
  }
  return i;
}

// What shows above the group's feet, where a low thing would have ended.
Tally tally_above(const FootGroup& group, const TraitSource& source) {
  Tally tally;
  for (std::size_t i = group.first; i <= group.last; ++i) {
    const Foot& foot = source.feet[i];
    if (!foot.stands) continue;
    const Line line = line_of(source, foot.index);
    const std::size_t middle = zone_end(line, foot.sample + kBlur, kLow * foot.distance);
    count(line, middle, zone_end(line, middle, kHigh * foot.distance), tally);
  }
  return tally;
}

// Share of carpet beside the foot that ends the group, on the lines beyond it.
double flank(const Foot& edge, std::size_t first, int direction, const TraitSource& source) {
  Tally tally;
  const std::size_t n = source.feet.size();
  for (std::size_t k = 0; k < kFlankLines; ++k) {
    const Foot& other = source.feet[direction > 0 ? first + k : first + n - k];
    const Line line = line_of(source, other.index);
    // All lines begin where the mask ends: by the distance from the centre, not by the index.
    const auto shift = std::ptrdiff_t{std::lround(edge.radius - other.radius)};
    const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(other.sample) + shift;
    if (start < 0) continue;
    const auto at = static_cast<std::size_t>(start);
    count(line, at, at + kAbove, tally);
  }
  return tally.share(tally.carpet);
}

double roughness(const FootGroup& group, const Feet& feet) {
  double sum = 0.0;
  int steps = 0;
  for (std::size_t i = group.first; i < group.last; ++i) {
    if (!feet[i].stands || !feet[i + 1].stands) continue;
    sum += std::abs(static_cast<double>(feet[i + 1].radius - feet[i].radius));
    ++steps;
  }
  return steps == 0 ? 1.0 : sum / steps / kRough;
}

double in_pixels(double length) {
  return std::clamp(length, -kMostPixels, kMostPixels) / kPixels;
}

double inside_hull(const FootGroup& group, const TraitSource& source) {
  const Foot& nearest = source.feet[source.feet.nearest_in(group)];
  const std::size_t end = source.hull.end(nearest.index);
  return static_cast<double>(end) - static_cast<double>(nearest.sample);
}

}  // namespace

ObstacleTraits traits_of(const FootGroup& group, const TraitSource& source) {
  const Feet& feet = source.feet;
  const double width = std::max(kNarrowest, feet.width_of(group));
  const double odd = std::log(width / (2.0 * source.robot_radius));
  const auto lines = static_cast<double>(group.last - group.first + 1);
  const Tally above = tally_above(group, source);
  const double left = flank(feet[group.first], group.first + feet.size() - 2, -1, source);
  const double right = flank(feet[group.last], group.last + 2, 1, source);
  return {odd * odd,
          in_pixels(feet.prominence(group).first),
          in_pixels(inside_hull(group, source)),
          above.share(above.shirt),
          above.share(above.shirt + above.dark),
          above.share(above.floor),
          static_cast<double>(feet.standing_in(group)) / lines,
          std::min(left, right),
          roughness(group, feet)};
}

}  // namespace teamsight::vision
