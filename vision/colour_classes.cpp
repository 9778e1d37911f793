// vision/colour_classes.cpp: filling the chroma table.
#include "vision/colour_classes.hpp"

#include <limits>

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

}  // namespace

ColourClasses::ColourClasses(const ColourParameters& parameters)
    : white_min_y_(parameters.white_min_y),
      black_max_y_(parameters.black_max_y) {
  for (std::size_t i = 0; i < table_.size(); ++i) {
    table_[i] = nearest_class(parameters, static_cast<int>(i >> 8U), static_cast<int>(i & 255U));
  }
}

}  // namespace teamsight::vision
