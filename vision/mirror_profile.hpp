// vision/mirror_profile.hpp: a mirror's meridian as a smooth curve with slope.
#pragma once

#include <cstddef>
#include <vector>

#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// The meridian y(x) of a mirror, x from the axis outwards, y from the pinhole; m.
///
/// A natural cubic spline through the given points: the slope decides where a ray goes, so it must
/// be continuous. At the apex (x = 0) the slope is that of the given points, not forced to 0: a
/// cone is a mirror too.
class MirrorProfile {
 public:
  /// @pre at least two points by strictly growing x
  explicit MirrorProfile(const std::vector<ProfilePoint>& points);

  /// @param x clamped to the profile
  [[nodiscard]] double height(double x) const;

  /// dy/dx.
  [[nodiscard]] double slope(double x) const;

  [[nodiscard]] double inner() const { return points_.front().x; }

  [[nodiscard]] double outer() const { return points_.back().x; }

 private:
  [[nodiscard]] std::size_t piece_of(double x) const;

  std::vector<ProfilePoint> points_;
  std::vector<double> bend_;  // second derivative at each point
};

}  // namespace teamsight::vision
