// vision/ball_pattern.cpp: see vision/ball_pattern.hpp.
#include "vision/ball_pattern.hpp"

namespace teamsight::vision {

BallPattern::BallPattern(std::span<const ColourClass> classes) : count_(classes.size()) {
  static_assert(static_cast<std::size_t>(ColourClass::kBlack) < kColourClasses);
  for (const ColourClass colour : classes) classes_[static_cast<std::size_t>(colour)] = true;
}

}  // namespace teamsight::vision
