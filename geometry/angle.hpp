// geometry/angle.hpp: the one place where angles are wrapped.
#pragma once

namespace teamsight {

/// Brings an angle into (-pi, pi], the range of every angle in this code base.
///
/// @param angle in radians; not-finite stays not-finite
[[nodiscard]] double wrap_angle(double angle);

/// The signed way from `from` to `to`, in (-pi, pi].
[[nodiscard]] inline double angle_difference(double to, double from) {
  return wrap_angle(to - from);
}

}  // namespace teamsight
