// vision/mirror/isometric.hpp: the part that maps the floor to the image at one constant scale.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "vision/mirror/profile.hpp"

namespace teamsight::mirror {

/// What the differential equation of the isometric part needs.
///
/// The floor at distance eta * tan(alpha) is seen at the angle alpha from the axis; then image
/// radius and floor distance are proportional.
struct IsometricParameters {
  double eta{0.0};             ///< floor distance per tangent of the camera ray; m
  double pinhole_height{0.0};  ///< over the floor; m
  double apex{0.0};            ///< height of the mirror's lowest point over the pinhole; m
  double tan_end{0.0};         ///< tan(alpha) at the part's outer end
};

/// The slope that sends the camera ray to its place on the floor, at one point of the mirror.
///
/// The law of reflection turns a ray at angle alpha from the axis into one at alpha + 2 gamma from
/// the downward vertical; solved for the slope angle gamma [Hicks99], without branches.
///
/// @param tan_alpha  tangent of the camera ray's angle from the axis
/// @param y          height of the point over the pinhole; m
[[nodiscard]] double isometric_slope(double tan_alpha, double y, const IsometricParameters& p);

/// Integrates the profile with an adaptive Dormand-Prince 5(4) method.
///
/// The independent variable is tan(alpha), that is the image radius, so that the part's end needs
/// no search and a profile that turns away from the camera is noticed.
///
/// @param intervals  nodes less one, equally spaced in the image; at least 1
/// @param tolerance  of one step, relative and absolute (m)
/// @return the nodes from apex to end; nothing if a step cannot be made,
/// which needs a parameter that is not finite
[[nodiscard]] std::optional<std::vector<Node>> integrate_isometric(const IsometricParameters& p,
                                                                   std::size_t intervals,
                                                                   double tolerance = 1e-13);

/// Constructs the profile pixel by pixel from its tangent planes, a local first-order method
/// [Lima01].
///
/// Between two camera rays the mirror is the tangent plane of the inner one.
///
/// @param facets  number of planes, equally spaced in the image; at least 1
/// @return the corners; each one's slope is that of the facet that begins there; nothing as above
[[nodiscard]] std::optional<std::vector<Node>> construct_isometric(const IsometricParameters& p,
                                                                   std::size_t facets);

/// How far the two constructions are apart.
struct IntegrationDifference {
  std::size_t facets{0};
  double profile{0.0};       ///< largest distance along the axis, at the same camera ray; m
  double end_slope{0.0};     ///< of the slopes at the outer end
  double ground{0.0};        ///< largest error on the floor of the mirror made of these facets; m
  double ground_range{0.0};  ///< floor distance at which that happens; m
};

/// Compares the local construction with the adaptive integration.
///
/// @return nothing if one of the two has no profile
[[nodiscard]] std::optional<IntegrationDifference> compare_integrations(
    const IsometricParameters& p, std::size_t facets);

}  // namespace teamsight::mirror
