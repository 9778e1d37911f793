// vision/colour_classes.cpp: filling the chroma table.
#include "vision/colour_classes.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace teamsight::vision {

namespace {

ColourClass nearest_class(const ColourParameters& parameters, int u, int v) {
  ColourClass result = ColourClass::kNone;
  int nearest = std::numeric_limits<int>::max();
  for (const ColourSample& sample : parameters.samples) {
    const int du = u - sample.u;
    const int dv = v - sample.v;
    const int square = du * du + dv * dv;
    if (square > sample.radius * sample.radius || square >= nearest) continue;
    nearest = square;
    result = sample.colour;
  }
  return result;
}

bool holds(const HueSector& sector, int u, int v) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double du = u - 128;
  const double dv = v - 128;
  const double chroma = std::hypot(du, dv);
  if (chroma < sector.min_chroma || chroma > sector.max_chroma) return false;
  const double way = std::fmod(std::atan2(dv, du) - sector.from, kTurn);
  return (way < 0.0 ? way + kTurn : way) <= sector.to - sector.from;
}

ColourClass class_at(const ColourParameters& parameters, int u, int v) {
  const ColourClass by_sample = nearest_class(parameters, u, v);
  if (by_sample != ColourClass::kNone) return by_sample;
  for (const HueSector& sector : parameters.sectors) {
    if (holds(sector, u, v)) return sector.colour;
  }
  return ColourClass::kNone;
}

}  // namespace

ColourClasses::ColourClasses(const ColourParameters& parameters)
    : white_min_y_(parameters.white_min_y),
      black_max_y_(parameters.black_max_y) {
  for (std::size_t i = 0; i < table_.size(); ++i) {
    table_[i] = class_at(parameters, static_cast<int>(i >> 8U), static_cast<int>(i & 255U));
  }
}

}  // namespace teamsight::vision
