// vision/mirror/isometric.cpp: two ways to integrate the isometric part.
#include "vision/mirror/isometric.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include <boost/numeric/odeint/integrate/integrate_times.hpp>
#include <boost/numeric/odeint/integrate/max_step_checker.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "geometry/expect.hpp"

namespace teamsight::mirror {
namespace {

namespace odeint = boost::numeric::odeint;

using State = std::array<double, 1>;  // y; x follows from tan(alpha) = x / y

/// Thrown through the integrator only: the surface lies along the camera ray, or nowhere.
struct NoSurface : std::runtime_error {
  NoSurface() : std::runtime_error("no surface") {}
};

/// With x = t y: dx = y dt + t dy and dy = s dx give dy/dt = s y / (1 - s t).
double derivative(double t, double y, const IsometricParameters& p) {
  const double slope = isometric_slope(t, y, p);
  const double facing = 1.0 - slope * t;
  if (!(facing > 1e-6) || !(y > 0.0)) {
    throw NoSurface();
  }
  return slope * y / facing;
}

std::vector<double> image_grid(double end, std::size_t intervals) {
  std::vector<double> grid(intervals + 1);
  for (std::size_t i = 0; i <= intervals; ++i) {
    grid[i] = end * static_cast<double>(i) / static_cast<double>(intervals);
  }
  return grid;
}

/// Where the ray t, reflected by the plane with this slope at height y, meets the floor.
double ground_of(double t, double y, double slope, double pinhole_height) {
  const double psi = std::atan(t) + 2.0 * std::atan(slope);
  return t * y + (y + pinhole_height) * std::tan(psi);
}

}  // namespace

double isometric_slope(double tan_alpha, double y, const IsometricParameters& p) {
  const double x = tan_alpha * y;
  const double psi = std::atan2(p.eta * tan_alpha - x, y + p.pinhole_height);
  return std::tan(0.5 * (psi - std::atan(tan_alpha)));
}

std::optional<std::vector<Node>> integrate_isometric(const IsometricParameters& p,
                                                     std::size_t intervals,
                                                     double tolerance) {
  TEAMSIGHT_EXPECT(intervals >= 1 && p.tan_end > 0.0 && p.apex > 0.0);
  const std::vector<double> grid = image_grid(p.tan_end, intervals);
  std::vector<Node> nodes;
  nodes.reserve(grid.size());
  State state{p.apex};
  try {
    odeint::integrate_times(
        odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<State>()),
        [&p](const State& y, State& rate, double t) { rate[0] = derivative(t, y[0], p); },
        state,
        grid,
        1e-4 * p.tan_end,
        [&p, &nodes](const State& y, double t) {
          nodes.push_back({t * y[0], y[0], isometric_slope(t, y[0], p)});
        });
  } catch (const std::runtime_error&) {  // NoSurface, or a step that could not be made small enough
    return std::nullopt;
  }
  return nodes;
}

std::optional<std::vector<Node>> construct_isometric(const IsometricParameters& p,
                                                     std::size_t facets) {
  TEAMSIGHT_EXPECT(facets >= 1 && p.tan_end > 0.0 && p.apex > 0.0);
  const std::vector<double> grid = image_grid(p.tan_end, facets);
  std::vector<Node> corners;
  corners.reserve(grid.size());
  double y = p.apex;
  for (std::size_t i = 0; i <= facets; ++i) {
    const double slope = isometric_slope(grid[i], y, p);
    corners.push_back({grid[i] * y, y, slope});
    if (i == facets) {
      break;
    }
    const double facing = 1.0 - slope * grid[i + 1];
    if (!(facing > 1e-6)) {
      return std::nullopt;
    }
    y *= (1.0 - slope * grid[i]) / facing;  // where the tangent plane meets the next camera ray
  }
  return corners;
}

std::optional<IntegrationDifference> compare_integrations(const IsometricParameters& p,
                                                          std::size_t facets) {
  const auto smooth = integrate_isometric(p, facets);
  const auto corners = construct_isometric(p, facets);
  if (!smooth || !corners) {
    return std::nullopt;
  }
  IntegrationDifference result{.facets = facets};
  result.end_slope = std::abs(corners->back().slope - smooth->back().slope);
  for (std::size_t i = 1; i <= facets; ++i) {
    const Node& corner = (*corners)[i];
    const double t = corner.x / corner.y;
    result.profile = std::max(result.profile, std::abs(corner.y - (*smooth)[i].y));
    // A facet sends its first ray to the right place and its last one furthest from it.
    const double seen = ground_of(t, corner.y, (*corners)[i - 1].slope, p.pinhole_height);
    const double error = std::abs(seen - p.eta * t);
    if (error > result.ground) {
      result.ground = error;
      result.ground_range = p.eta * t;
    }
  }
  return result;
}

}  // namespace teamsight::mirror
