// vision/ball_pattern.cpp: see vision/ball_pattern.hpp.
#include "vision/ball_pattern.hpp"

#include <algorithm>

namespace teamsight::vision {

namespace {

// Shares of the luminance of the carpet beside a pixel, as in surface.cpp.
constexpr float kBlack = 0.56F;  // darker is black whatever its colour
constexpr float kDark = 0.72F;
constexpr float kBright = 1.12F;
constexpr float kLeastRise = 6.0F;  // grey levels of white over carpet
constexpr float kSaturated = 255.0F;

}  // namespace

BallPattern::BallPattern(std::span<const ColourClass> classes) : count_(classes.size()) {
  static_assert(static_cast<std::size_t>(ColourClass::kBlack) < kColourClasses);
  for (const ColourClass colour : classes) classes_[static_cast<std::size_t>(colour)] = true;
}

ColourClass BallPattern::look(std::uint8_t y, ColourClass chromatic, float carpet) const {
  const auto luminance = static_cast<float>(y);
  if (chromatic != ColourClass::kNone && has(chromatic)) return chromatic;
  if (luminance < kBlack * carpet) return ColourClass::kBlack;
  if (chromatic != ColourClass::kNone) return chromatic;
  const float paint = std::max(kBright * carpet, carpet + kLeastRise);
  if (luminance > std::min(paint, 0.5F * (carpet + kSaturated))) return ColourClass::kWhite;
  return luminance < kDark * carpet ? ColourClass::kBlack : ColourClass::kNone;
}

}  // namespace teamsight::vision
