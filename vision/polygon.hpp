// vision/polygon.hpp: what lies inside a window of the image.
#pragma once

#include <algorithm>

#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// Whether `point` lies inside, by the even-odd rule.
[[nodiscard]] inline bool is_inside(const Polygon& polygon, const Corner& point) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Corner& a = polygon[i];
    const Corner& b = polygon[j];
    if ((a.v > point.v) == (b.v > point.v)) continue;
    if (point.u < a.u + (b.u - a.u) * (point.v - a.v) / (b.v - a.v)) inside = !inside;
  }
  return inside;
}

/// Whether one of the mask's polygons hides this place.
[[nodiscard]] inline bool is_hidden(const Mask& mask, const Corner& point) {
  return std::ranges::any_of(mask.polygons,
                             [&](const Polygon& polygon) { return is_inside(polygon, point); });
}

}  // namespace teamsight::vision
