// fusion/feet.cpp: see fusion/feet.hpp.
#include "fusion/feet.hpp"

#include <cmath>

namespace teamsight::fusion {

Touch likeliest_touch(const Eigen::Vector2d& ball_F,
                      double ball_var,
                      const FeetList& feet,
                      double reach) {
  Touch touch;
  for (const Feet& foot : feet) {
    const Eigen::Vector2d way = ball_F - foot.p_F;
    const double distance = way.norm();
    const double var = ball_var + foot.var;
    const double beyond = distance - foot.radius - reach;
    const double probability = 0.5 * std::erfc(beyond / std::sqrt(2.0 * var));
    if (probability <= touch.probability) continue;
    // A way that is not longer than it is uncertain has no direction.
    touch = {probability, way / std::sqrt(distance * distance + var)};
  }
  return touch;
}

}  // namespace teamsight::fusion
