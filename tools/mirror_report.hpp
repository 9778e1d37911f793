// tools/mirror_report.hpp: a designed mirror as JSON for other programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "vision/mirror/design.hpp"
#include "vision/mirror/trace.hpp"

namespace teamsight::tools {

/// Everything about one mirror: points, radii, image split, resolution over distance, blind zone,
/// margins of the checks, difference of the two integrations. What a mirror does not have is null.
///
/// @param pixel_pitch  of the sensor, m, for the focal length of the lens
[[nodiscard]] nlohmann::ordered_json mirror_report(const mirror::Mirror& mirror,
                                                   std::optional<double> pixel_pitch);

/// What one pixel radius shows: floor distance, part, and the height of its ray at some distances.
///
/// @param distances  from the axis; m
/// @return nulls where the pixel lies beside the mirror or the ray has no such point
[[nodiscard]] nlohmann::ordered_json trace_report(const mirror::Mirror& mirror,
                                                  double radius_px,
                                                  const std::vector<double>& distances);

}  // namespace teamsight::tools
