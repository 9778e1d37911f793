// tools/svg_ticks.hpp: where an axis gets its ticks, and how it maps to pixels.
#pragma once

#include <string>
#include <vector>

#include "tools/svg_plot.hpp"

namespace teamsight::plot {

/// Round numbers on the axis: steps of 1, 2 or 5 times a power of ten, or 1-2-5 per decade if
/// logarithmic.
///
/// @param count  about how many are wanted, 2 or more
[[nodiscard]] std::vector<double> ticks(const Axis& axis, int count);

/// A tick's number without needless digits.
[[nodiscard]] std::string tick_text(double value);

/// Where a value lies along the axis: 0 at `low`, 1 at `high`. Not finite for what a logarithm
/// cannot show.
[[nodiscard]] double along(const Axis& axis, double value);

}  // namespace teamsight::plot
