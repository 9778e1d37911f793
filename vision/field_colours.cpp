// vision/field_colours.cpp: votes over the chroma plane, then medians from histograms.
#include "vision/field_colours.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace teamsight::vision {

namespace {

constexpr double kCarpetShare = 0.1;      // of the floor, around the most frequent hue
constexpr int kBrighter = 35;             // grey levels over the carpet
constexpr std::size_t kFewestPaint = 50;  // samples
// Chroma over luminance: what shade, a vignette and exposure leave as it is. Dark is noise, mostly.
constexpr float kDark = 16.0F;  // grey levels, added to luminance
constexpr float kBinsOfOne = 32.0F;
constexpr float kNear = 0.1F;  // this is carpet
constexpr float kGrey = 0.06F;
constexpr float kRed = 0.03F;
constexpr float kPaint = 0.5F;       // of the carpet's own: paint is at least as far from it
constexpr float kMostColour = 0.3F;  // of paint, or the carpet's own: a ball has more

/// Chroma over luminance.
struct Tint {
  float u{0.0F};
  float v{0.0F};
};

Tint tint_of(const SampledColour& sample) {
  const float scale = 1.0F / (static_cast<float>(sample.y) + kDark);
  return {scale * static_cast<float>(sample.u - 128), scale * static_cast<float>(sample.v - 128)};
}

// Grey is no carpet, paint, body and people are grey; nor is what is more red than green.
bool may_be_carpet(const SampledColour& sample) {
  const Tint tint = tint_of(sample);
  return !is_saturated(sample) && tint.v < -kRed &&
         tint.u * tint.u + tint.v * tint.v > kGrey * kGrey;
}

bool is_near(const SampledColour& sample, const Tint& middle) {
  const Tint tint = tint_of(sample);
  return std::abs(tint.u - middle.u) < kNear && std::abs(tint.v - middle.v) < kNear;
}

bool may_be_paint(const SampledColour& sample, const SampledColour& green) {
  const Tint carpet = tint_of(green);
  const Tint tint = tint_of(sample);
  const float colour = std::hypot(carpet.u, carpet.v);
  return sample.y > green.y + kBrighter && !is_saturated(sample) &&
         std::hypot(tint.u, tint.v) < std::max(kMostColour, colour) &&
         std::hypot(tint.u - carpet.u, tint.v - carpet.v) > kPaint * colour;
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

std::size_t FieldColourMeter::bin_of(const SampledColour& sample) {
  static constexpr int kMost = static_cast<int>(kBins) - 1;
  const auto place = [](float tint) {
    const float shown = kBinsOfOne * tint + 0.5F * static_cast<float>(kBins);
    return static_cast<std::size_t>(std::clamp(static_cast<int>(shown), 0, kMost));
  };
  const Tint tint = tint_of(sample);
  return place(tint.u) * kBins + place(tint.v);
}

std::optional<SampledColour> FieldColourMeter::green_of(std::span<const SampledColour> floor) {
  votes_.fill(0);
  for (const SampledColour& p : floor) {
    if (may_be_carpet(p)) votes_[bin_of(p)] += p.y;
  }
  const auto best = static_cast<std::size_t>(std::ranges::max_element(votes_) - votes_.begin());
  const auto middle_of = [](std::size_t bin) {
    return (static_cast<float>(bin) + 0.5F - 0.5F * static_cast<float>(kBins)) / kBinsOfOne;
  };
  const Tint middle{middle_of(best / kBins), middle_of(best % kBins)};
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
