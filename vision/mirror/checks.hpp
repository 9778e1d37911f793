// vision/mirror/checks.hpp: whether a profile works as a mirror, and with what margin.
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/result.hpp"
#include "vision/mirror/assembly.hpp"
#include "vision/mirror/failure.hpp"

namespace teamsight::mirror {

/// The worst value of a quantity along the profile.
struct Worst {
  double value{0.0};
  double x{0.0};  ///< distance from the axis where it occurs; m
};

/// What the checks measured on a mirror that passed them.
struct Margins {
  Worst joint_slope_jump;  ///< at joints that should be smooth
  Worst facing;            ///< least angle between camera ray and surface; rad
  Worst second_hit;        ///< least angle between a reflected ray and the mirror further out; rad
  std::optional<Worst>
      ring_clearance;  ///< between the ring's rays and the body; m; nothing: no body
};

/// Checks that x grows, y is positive, and nothing is infinite.
///
/// @return the first fault; nothing if the profile is a function of x
[[nodiscard]] std::optional<Failure> check_function(const Profile& profile);

/// Measures all margins.
///
/// @param ring  index of the part that must be seen past the body, if there is one
/// @return the margins, or the first condition that fails: function, slope jump, facing, second
/// hit,
///         floor order, ring hidden
[[nodiscard]] Result<Margins, Failure> check(const Assembly& assembly,
                                             std::optional<std::size_t> ring = std::nullopt);

}  // namespace teamsight::mirror
