// vision/mirror/multi_part.hpp: isometric part, constant-curvature part and ring, closed into one
// mirror.
#pragma once

#include <cstddef>

#include "geometry/result.hpp"
#include "vision/mirror/curvature.hpp"
#include "vision/mirror/failure.hpp"
#include "vision/mirror/isometric.hpp"
#include "vision/mirror/profile.hpp"
#include "vision/mirror/shapes.hpp"

namespace teamsight::mirror {

/// The free parameters of the multi-part mirror besides its rim; the defaults close [Lima01].
struct MultiPart {
  double isometric_range{6.0};   ///< floor distance up to which the scale is constant; m
  double isometric_share{0.88};  ///< image radius of A by that of B; 0 to 1
  double max_distance{11.2};     ///< where the outermost ray of the middle part ends; m
  double max_height{0.6};        ///< height that this ray has there; m
  double ring_near{0.39};        ///< floor distance at the ring's inner edge; m
  double ring_far{0.51};         ///< at its outer edge; m

  friend bool operator==(const MultiPart&, const MultiPart&) = default;
};

/// The closed design. A: end of the isometric part; B: inner edge of the ring; C: the rim.
struct MultiPartSolution {
  MultiPart parameters;
  IsometricParameters isometric;
  Arc arc;  ///< from A to B
  Node point_A;
  Node point_B;  ///< with the slope of the arc; the ring begins there with slope 0
  Node point_C;

  /// The three parts, sampled.
  [[nodiscard]] Profile profile() const;
};

/// Closes the design: finds the apex height for which the arc from A ends in B.
///
/// The ring fixes B and the camera's place, B's ray fixes the slope there, the share fixes the
/// camera ray of A; the height of the apex is then the one unknown of one equation.
///
/// @param rim  where the ring ends: radius, m, and height over the floor, m
/// @return the solution, or which condition cannot be met and by how much
[[nodiscard]] Result<MultiPartSolution, Failure> solve(const MultiPart& parameters, const Rim& rim);

}  // namespace teamsight::mirror
