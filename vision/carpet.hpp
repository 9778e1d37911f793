// vision/carpet.hpp: the field's own green, measured in each frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "vision/pixel_reader.hpp"

namespace teamsight::vision {

/// What the carpet looks like in one frame.
struct Carpet {
  float luminance{0.0F};  ///< median, grey levels; 0: no carpet was seen
  float u{0.0F};          ///< mean chroma as the difference from grey, grey levels
  float v{0.0F};
  float share{0.0F};  ///< of the samples where floor could be seen, in [0, 1]

  friend bool operator==(const Carpet&, const Carpet&) = default;
};

/// Collects the samples of one frame that have the carpet's colour.
class CarpetMeter {
 public:
  void clear() { *this = {}; }

  void add_green(std::uint8_t luminance, Chroma chroma) {
    ++histogram_[luminance];
    sum_u_ += chroma.u;
    sum_v_ += chroma.v;
  }

  void add_samples(std::size_t count) { samples_ += count; }

  [[nodiscard]] Carpet carpet() const;

 private:
  std::array<std::uint32_t, 256> histogram_{};
  std::uint64_t sum_u_{0};
  std::uint64_t sum_v_{0};
  std::size_t samples_{0};
};

}  // namespace teamsight::vision
