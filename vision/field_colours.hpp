// vision/field_colours.hpp: the two colours every field has, without asking any colour class.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// Whether a colour is too bright to tell its hue.
[[nodiscard]] constexpr bool is_saturated(const SampledColour& colour) {
  return colour.y >= 245;
}

/// Finds the carpet as the most frequent chroma of the floor, and the paint as what is much
/// brighter. Allocates nothing; its tables are its only state.
class FieldColourMeter {
 public:
  /// @param floor  what is seen where floor could be
  /// @return nothing if no chroma stands out or too little is brighter than it; a white of 255 if
  /// the
  ///         paint is saturated
  [[nodiscard]] std::optional<FieldColours> measure(std::span<const SampledColour> floor);

 private:
  static constexpr std::size_t kBins = 64;
  using Histogram = std::array<std::uint32_t, 256>;

  /// Counts of a set of samples.
  struct Channels {
    Histogram y;
    Histogram u;
    Histogram v;
    std::size_t count;
  };

  [[nodiscard]] static std::size_t bin_of(const SampledColour& sample);
  [[nodiscard]] std::optional<SampledColour> green_of(std::span<const SampledColour> floor);
  [[nodiscard]] std::optional<SampledColour> white_of(std::span<const SampledColour> floor,
                                                      const SampledColour& green);
  void collect_paint(std::span<const SampledColour> floor,
                     const SampledColour& green,
                     std::uint8_t least_y);
  static void add(const SampledColour& sample, Channels& to);
  [[nodiscard]] static SampledColour median_of(const Channels& channels);

  std::array<std::uint32_t, kBins * kBins> votes_{};
  Channels carpet_{};
  Channels paint_{};
};

}  // namespace teamsight::vision
