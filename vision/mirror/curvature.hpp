// vision/mirror/curvature.hpp: the part of constant curvature, and the condition that ends it.
#pragma once

#include <cstddef>
#include <vector>

#include "vision/mirror/profile.hpp"

namespace teamsight::mirror {

/// The slope angle at B that makes its ray pass the height `max_height` at `max_distance`.
///
/// @param t_B   tangent of the camera ray to B
/// @param x_B           distance of B from the axis; m
/// @param height_B      of B over the floor; m
/// @param max_distance  from the axis; m, more than x_B
/// @param max_height    over the floor; m
/// @return gamma_B, angle of the tangent over the horizontal; rad
[[nodiscard]] double outer_slope_angle(
    double t_B, double x_B, double height_B, double max_distance, double max_height);

/// The circle through A with A's tangent on which the slope angle reaches gamma_B at x_B.
struct Arc {
  Node start;         ///< A
  double end_x{0.0};  ///< x of B; m
  double curvature{
      0.0};  ///< signed, 1/m; positive where the slope grows outwards, 0: a straight line
};

/// @param start      A; @param end_x  x of B, m, more than A's; @param end_angle  gamma_B, rad
[[nodiscard]] Arc make_arc(const Node& start, double end_x, double end_angle);

/// A point of the arc. @param x  m, from A's to B's
[[nodiscard]] Node at(const Arc& arc, double x);

/// The arc as nodes, equally spaced in x. @param intervals  nodes less one, at least 1
[[nodiscard]] std::vector<Node> sample(const Arc& arc, std::size_t intervals);

}  // namespace teamsight::mirror
