// vision/ball_pattern.hpp: which of a patterned ball's colours a pixel shows.
#pragma once

#include <algorithm>
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
  // Shares of the luminance of the carpet beside a pixel, as in surface.cpp.
  static constexpr float kBlack = 0.56F;  // darker is black whatever its colour
  static constexpr float kDark = 0.72F;
  static constexpr float kBright = 1.12F;
  static constexpr float kLeastRise = 6.0F;  // grey levels of white over carpet
  static constexpr float kSaturated = 255.0F;

  std::array<bool, kColourClasses> classes_{};
  std::size_t count_{0};
};

inline ColourClass BallPattern::look(std::uint8_t y, ColourClass chromatic, float carpet) const {
  const auto luminance = static_cast<float>(y);
  if (chromatic != ColourClass::kNone && has(chromatic)) return chromatic;
  if (luminance < kBlack * carpet) return ColourClass::kBlack;
  if (chromatic != ColourClass::kNone) return chromatic;
  const float paint = std::max(kBright * carpet, carpet + kLeastRise);
  if (luminance > std::min(paint, 0.5F * (carpet + kSaturated))) return ColourClass::kWhite;
  return luminance < kDark * carpet ? ColourClass::kBlack : ColourClass::kNone;
}

}  // namespace teamsight::vision
