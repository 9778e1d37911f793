// tools/score_histogram.hpp: errors of a method as the founding paper drew them (figure 10).
#pragma once

#include <string>

#include "bench/locate_score/tally.hpp"

namespace teamsight::tools {

/// Histograms of the errors in x, y and theta with the normal distribution of the same mean and
/// deviation, as an SVG document.
///
/// @pre the tally has errors
[[nodiscard]] std::string error_histogram(const std::string& method,
                                          const locate_score::Tally& tally);

}  // namespace teamsight::tools
