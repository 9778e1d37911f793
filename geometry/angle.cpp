// geometry/angle.cpp: wrapping of angles.
#include "geometry/angle.hpp"

#include <cmath>
#include <numbers>

namespace teamsight {

double wrap_angle(double angle) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double wrapped = std::remainder(angle, kTurn);  // in [-pi, pi]
  return wrapped <= -std::numbers::pi ? wrapped + kTurn : wrapped;
}

}  // namespace teamsight
