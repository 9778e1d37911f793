// vision/mirror/shapes.hpp: the classical mirrors, from the axis to the rim, with exact slopes.
#pragma once

#include <cstddef>

#include "geometry/result.hpp"
#include "vision/mirror/failure.hpp"
#include "vision/mirror/profile.hpp"

namespace teamsight::mirror {

/// A cone, tip down.
struct Cone {
  double apex{0.0};         ///< height of the tip over the pinhole; m
  double slope_angle{0.0};  ///< of the surface over the horizontal; rad, 0 to pi/2

  friend bool operator==(const Cone&, const Cone&) = default;
};

/// The lower part of a ball.
struct Sphere {
  double apex{0.0};    ///< height of the lowest point over the pinhole; m
  double radius{0.0};  ///< m

  friend bool operator==(const Sphere&, const Sphere&) = default;
};

/// y = apex + x^2 / (2 apex_radius). Rays parallel to the axis seem to come from its focus, at
/// apex + apex_radius / 2; with a pinhole camera it has no single viewpoint.
struct Paraboloid {
  double apex{0.0};         ///< height of the lowest point over the pinhole; m
  double apex_radius{0.0};  ///< radius of curvature there; m

  friend bool operator==(const Paraboloid&, const Paraboloid&) = default;
};

/// The sheet of a hyperboloid whose far focus is the pinhole: every ray it shows seems to come from
/// the other focus, 2 sqrt(a^2 + b^2) above.
struct Hyperboloid {
  double a{0.0};  ///< semi-axis along the mirror's axis; m
  double b{0.0};  ///< semi-axis across; m

  friend bool operator==(const Hyperboloid&, const Hyperboloid&) = default;
};

/// The two-part mirror of 1999: a cone with a spherical apex and a common tangent [Bonarini99].
///
/// Follows from what it shows: the joint sees the floor at `near`, the rim at `far`.
struct ConeWithApex {
  double near_range{0.0};  ///< floor distance at the joint; m
  double far_range{0.0};   ///< floor distance at the rim; m
  double rim_y{0.0};       ///< height of the rim over the pinhole; m

  friend bool operator==(const ConeWithApex&, const ConeWithApex&) = default;
};

/// Where a mirror ends.
struct Rim {
  double radius{0.0};  ///< m
  double height{0.0};  ///< over the floor; m

  friend bool operator==(const Rim&, const Rim&) = default;
};

/// The profile of each shape from the axis to the rim.
///
/// @param intervals  nodes less one of each curved part, at least 1
/// @return the profile, or which condition cannot be met and by how much
[[nodiscard]] Result<Profile, Failure> make_profile(const Cone& shape,
                                                    const Rim& rim,
                                                    std::size_t intervals);
[[nodiscard]] Result<Profile, Failure> make_profile(const Sphere& shape,
                                                    const Rim& rim,
                                                    std::size_t intervals);
[[nodiscard]] Result<Profile, Failure> make_profile(const Paraboloid& shape,
                                                    const Rim& rim,
                                                    std::size_t intervals);
[[nodiscard]] Result<Profile, Failure> make_profile(const Hyperboloid& shape,
                                                    const Rim& rim,
                                                    std::size_t intervals);
[[nodiscard]] Result<Profile, Failure> make_profile(const ConeWithApex& shape,
                                                    const Rim& rim,
                                                    std::size_t intervals);

}  // namespace teamsight::mirror
