// tools/score_rounding.hpp: how many digits a score is worth.
#pragma once

#include <cmath>

namespace teamsight::tools {

/// To a tenth of a millimetre and the like: more digits are noise.
[[nodiscard]] inline double rounded(double value) {
  return std::round(value * 1e4) / 1e4;
}

}  // namespace teamsight::tools
