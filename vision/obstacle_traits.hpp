// vision/obstacle_traits.hpp: what tells robots and people on the carpet from what surrounds it.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "vision/carpet_hull.hpp"
#include "vision/obstacle_feet.hpp"
#include "vision/radial_scan.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

/// In the order of an ObstacleTraits.
inline constexpr std::array<std::string_view, 9> kTraitNames{
    "odd_width",         // square of the logarithm of its width over a robot's
    "carpet_beside",     // how far carpet goes on beside it, on the worse side; 20 px
    "inside_hull",       // from its foot outwards to the carpet's convex hull; 20 px
    "shirt_high",        // share of strong colours from 1.4 to 2.5 times its distance
    "standing_high",     // share of dark or strong colours there
    "floor_high",        // share of carpet and paint there
    "closed",            // share of its lines that have a foot
    "carpet_at_flanks",  // share of carpet just beside its foot, on the worse side
    "rough_foot",        // mean step of the foot from line to line; 5 px
};

inline constexpr std::size_t kTraits = kTraitNames.size();
using ObstacleTraits = std::array<double, kTraits>;

/// One frame as the traits need it.
struct TraitSource {
  const Feet& feet;
  const RadialScan& scan;
  const ScanLines& lines;
  const CarpetHull& hull;
  double robot_radius{0.25};  ///< m
};

[[nodiscard]] ObstacleTraits traits_of(const FootGroup& group, const TraitSource& source);

}  // namespace teamsight::vision
