// vision/ball_pattern.hpp: which of a patterned ball's colours a pixel shows.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "vision/colour_classes.hpp"
#include "vision/pixel_reader.hpp"

namespace teamsight::vision {

inline constexpr std::size_t kColourClasses = 10;

/// The classes of a ball that has several. White and black are judged as `surface` judges paint and
/// robots: brighter and darker than the carpet beside it, by its own light.
class BallPattern {
 public:
  /// Of no class: no such ball.
  explicit BallPattern(std::span<const ColourClass> classes);

  [[nodiscard]] bool is_any() const { return count_ > 0; }

  [[nodiscard]] bool has(ColourClass colour) const {
    return classes_[static_cast<std::size_t>(colour)];
  }

  /// What a pixel shows.
  ///
  /// @param carpet  luminance of the carpet beside it, grey levels
  /// @return kGreen: carpet; kNone: between white, black and grey, as where they meet; else a
  ///         class, of the ball or not
  [[nodiscard]] ColourClass look(std::uint8_t y, ColourClass chromatic, float carpet) const;

 private:
  std::array<bool, kColourClasses> classes_{};
  std::size_t count_{0};
};

}  // namespace teamsight::vision
