// vision/field_colours.cpp: votes over the chroma plane, then medians from histograms.
#include "vision/field_colours.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace teamsight::vision {

namespace {

constexpr unsigned kBinBits = 2;          // of chroma: four levels share a bin
constexpr double kCarpetShare = 0.1;      // of the floor, around the most frequent chroma
constexpr int kNear = 10;                 // of chroma: this is carpet
constexpr int kBrighter = 35;             // grey levels over the carpet
constexpr std::size_t kFewestPaint = 50;  // samples

// Grey is no carpet, paint, body and people are grey; nor is what is more red than green.
bool may_be_carpet(const SampledColour& sample) {
  const int du = sample.u - 128;
  const int dv = sample.v - 128;
  return sample.v < 124 && du * du + dv * dv > 64;
}

bool is_near(const SampledColour& sample, const SampledColour& middle) {
  return std::abs(sample.u - middle.u) < kNear && std::abs(sample.v - middle.v) < kNear;
}

bool may_be_paint(const SampledColour& sample, const SampledColour& green) {
  const int du = sample.u - green.u;
  const int dv = sample.v - green.v;
  return sample.y > green.y + kBrighter && !is_saturated(sample) &&
         4 * (du * du + dv * dv) > kNear * kNear;
}

/// The value below which `rank` of the counted ones lie.
template <class Histogram>
std::uint8_t at_rank(const Histogram& histogram, std::size_t rank) {
  std::size_t below = 0;
  std::size_t value = 0;
  while (value + 1 < histogram.size() && below + histogram[value] <= rank) {
    below += histogram[value++];
  }
  return static_cast<std::uint8_t>(value);
}

}  // namespace

void FieldColourMeter::add(const SampledColour& sample, Channels& to) {
  ++to.y[sample.y];
  ++to.u[sample.u];
  ++to.v[sample.v];
  ++to.count;
}

SampledColour FieldColourMeter::median_of(const Channels& channels) {
  const std::size_t rank = (channels.count - 1) / 2;
  return {at_rank(channels.y, rank), at_rank(channels.u, rank), at_rank(channels.v, rank)};
}

SampledColour FieldColourMeter::most_frequent(std::span<const SampledColour> floor) {
  votes_.fill(0);
  for (const SampledColour& p : floor) {
    if (may_be_carpet(p)) ++votes_[(std::size_t{p.u} >> kBinBits) * kBins + (p.v >> kBinBits)];
  }
  const auto best = static_cast<std::size_t>(std::ranges::max_element(votes_) - votes_.begin());
  const auto middle = [](std::size_t bin) {
    return static_cast<std::uint8_t>((bin << kBinBits) + (1U << (kBinBits - 1)));
  };
  return {0, middle(best / kBins), middle(best % kBins)};
}

std::optional<SampledColour> FieldColourMeter::green_of(std::span<const SampledColour> floor) {
  const SampledColour middle = most_frequent(floor);
  carpet_ = {};
  for (const SampledColour& p : floor) {
    if (is_near(p, middle) && may_be_carpet(p)) add(p, carpet_);
  }
  const double least = kCarpetShare * static_cast<double>(floor.size());
  if (carpet_.count == 0 || static_cast<double>(carpet_.count) < least) return std::nullopt;
  return median_of(carpet_);
}

void FieldColourMeter::collect_paint(std::span<const SampledColour> floor,
                                     const SampledColour& green,
                                     std::uint8_t least_y) {
  paint_ = {};
  for (const SampledColour& p : floor) {
    if (p.y >= least_y && may_be_paint(p, green)) add(p, paint_);
  }
}

std::optional<SampledColour> FieldColourMeter::white_of(std::span<const SampledColour> floor,
                                                        const SampledColour& green) {
  collect_paint(floor, green, 0);
  const auto saturated = static_cast<std::size_t>(std::ranges::count_if(floor, is_saturated));
  // More than its edges and a few reflections: what is left of the paint is mixed with carpet.
  if (saturated >= kFewestPaint && 3 * saturated > paint_.count + saturated) {
    return SampledColour{255, 128, 128};
  }
  if (paint_.count < kFewestPaint) return std::nullopt;
  // The brightest tenth: what is less bright is mixed with carpet.
  const std::size_t kept = std::max(kFewestPaint, paint_.count / 10);
  collect_paint(floor, green, at_rank(paint_.y, paint_.count - kept));
  return median_of(paint_);
}

std::optional<FieldColours> FieldColourMeter::measure(std::span<const SampledColour> floor) {
  const auto green = green_of(floor);
  if (!green) return std::nullopt;
  const auto white = white_of(floor, *green);
  if (!white) return std::nullopt;
  return FieldColours{*green, *white};
}

}  // namespace teamsight::vision
