// vision/light.hpp: whether a frame can be judged at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace teamsight::vision {

/// What the light in a frame allows.
enum class Light : std::uint8_t {
  kUnknown,
  kGood,
  kDark,     ///< too dark to tell the carpet from anything
  kGlare,    ///< a good part of the floor is saturated
  kCovered,  ///< something even fills the picture: a cap, fog, a dead sensor
};

/// Sums up the luminance along the radial scan lines.
class LightMeter {
 public:
  void add(std::span<const std::uint8_t> profile);

  /// kUnknown if nothing was added.
  [[nodiscard]] Light light() const;

 private:
  std::uint64_t sum_{0};
  std::uint64_t sum_square_{0};
  std::size_t saturated_{0};
  std::size_t count_{0};
};

}  // namespace teamsight::vision
