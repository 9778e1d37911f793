// tools/mirror_drawings.hpp: what mirrors look like and what they see, as plots.
#pragma once

#include <vector>

#include "tools/svg_plot.hpp"
#include "vision/mirror/design.hpp"

namespace teamsight::tools {

/// The meridian with rays in the mirror's neighbourhood and down to the floor; one row per mirror.
[[nodiscard]] plot::Figure profile_figure(const std::vector<mirror::Mirror>& mirrors);

/// Floor distance over image radius: one mirror by its parts, several ones by name.
[[nodiscard]] plot::Figure distance_figure(const std::vector<mirror::Mirror>& mirrors);

/// The error on the floor that one pixel means, over distance.
[[nodiscard]] plot::Figure pixel_error_figure(const std::vector<mirror::Mirror>& mirrors);

}  // namespace teamsight::tools
