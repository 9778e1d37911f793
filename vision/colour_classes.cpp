// vision/colour_classes.cpp: filling the chroma table.
#include "vision/colour_classes.hpp"

#include <limits>

namespace teamsight::vision {

ColourClasses::ColourClasses(const ColourParameters& parameters)
    : white_min_y_(parameters.white_min_y),
      black_max_y_(parameters.black_max_y) {
  for (int u = 0; u < 256; ++u) {
    for (int v = 0; v < 256; ++v) {
      int nearest = std::numeric_limits<int>::max();
      for (const ColourSample& sample : parameters.samples) {
        const int du = u - sample.u;
        const int dv = v - sample.v;
        const int square = du * du + dv * dv;
        if (square > sample.radius * sample.radius || square >= nearest) continue;
        nearest = square;
        table_[static_cast<std::size_t>(u) << 8U | static_cast<std::size_t>(v)] = sample.colour;
      }
    }
  }
}

}  // namespace teamsight::vision
