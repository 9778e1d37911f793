// vision/mirror/shapes.cpp: closed forms of the classical mirrors.
#include "vision/mirror/shapes.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>
#include <fmt/format.h>

namespace teamsight::mirror {
namespace {

/// Samples `shape(x)` between two distances from the axis, equally spaced.
template <class NodeAt>
Part sample_part(std::string name,
                 std::pair<double, double> range,
                 std::size_t intervals,
                 NodeAt shape) {
  Part part{.name = std::move(name), .nodes = {}};
  part.nodes.reserve(intervals + 1);
  const auto [from, to] = range;
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(intervals);
    part.nodes.push_back(shape(i == intervals ? to : from + (to - from) * t));
  }
  return part;
}

Node on_sphere(double x, double apex, double radius) {
  const double rise = std::sqrt((radius - x) * (radius + x));
  return {x, apex + radius - rise, x / rise};
}

/// Where the cone of the two-part mirror shows the floor, at distance x from the axis.
double cone_range(double x, double slope_angle, const ConeWithApex& shape, const Rim& rim) {
  const double y = shape.rim_y - (rim.radius - x) * std::tan(slope_angle);
  const double psi = std::atan2(x, y) + 2.0 * slope_angle;
  return x + (rim.height - shape.rim_y + y) * std::tan(psi);
}

double joint_radius(double slope_angle, const ConeWithApex& shape, const Rim& rim) {
  const auto miss = [&](double x) {
    return cone_range(x, slope_angle, shape, rim) - shape.near_range;
  };
  std::uintmax_t iterations = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      miss, 0.0, rim.radius, boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (low + high);
}

}  // namespace

Result<Profile, Failure> make_profile(const Cone& shape, const Rim& rim, std::size_t intervals) {
  const double slope = std::tan(shape.slope_angle);
  return Profile{{sample_part("cone", {0.0, rim.radius}, intervals, [&](double x) {
    return Node{x, shape.apex + slope * x, slope};
  })}};
}

Result<Profile, Failure> make_profile(const Sphere& shape, const Rim& rim, std::size_t intervals) {
  if (!(rim.radius < shape.radius)) {
    const double excess = rim.radius - shape.radius;
    return failure(Failure{
        Condition::kSolution,
        excess,
        fmt::format("no solution: a sphere of radius {:.4f} m has no rim of radius {:.4f} m, "
                    "{:.4f} m too wide",
                    shape.radius,
                    rim.radius,
                    excess)});
  }
  return Profile{{sample_part("sphere", {0.0, rim.radius}, intervals, [&](double x) {
    return on_sphere(x, shape.apex, shape.radius);
  })}};
}

Result<Profile, Failure> make_profile(const Paraboloid& shape,
                                      const Rim& rim,
                                      std::size_t intervals) {
  const double r = shape.apex_radius;
  return Profile{{sample_part("paraboloid", {0.0, rim.radius}, intervals, [&](double x) {
    return Node{x, shape.apex + x * x / (2.0 * r), x / r};
  })}};
}

Result<Profile, Failure> make_profile(const Hyperboloid& shape,
                                      const Rim& rim,
                                      std::size_t intervals) {
  const auto [a, b] = shape;
  const double centre = std::hypot(a, b);
  return Profile{
      {sample_part("hyperboloid", {0.0, rim.radius}, intervals, [a = a, b = b, centre](double x) {
        const double root = std::hypot(1.0, x / b);
        return Node{x, centre + a * root, a * x / (b * b * root)};
      })}};
}

Result<Profile, Failure> make_profile(const ConeWithApex& shape,
                                      const Rim& rim,
                                      std::size_t intervals) {
  const double psi_rim = std::atan2(shape.far_range - rim.radius, rim.height);
  const double slope_angle = 0.5 * (psi_rim - std::atan2(rim.radius, shape.rim_y));
  if (!(slope_angle > 0.0)) {
    return failure(Failure{
        Condition::kSolution,
        -slope_angle,
        fmt::format(
            "no solution: the camera ray to the rim is {:.3f} deg flatter than the ray from "
            "there to {:.3f} m",
            -2.0 * slope_angle * 180.0 / std::numbers::pi,
            shape.far_range)});
  }
  const double nearest = cone_range(0.0, slope_angle, shape, rim);
  if (!(nearest < shape.near_range)) {
    return failure(Failure{
        Condition::kSolution,
        nearest - shape.near_range,
        fmt::format(
            "no solution: the cone that shows {:.3f} m at the rim shows nothing nearer than "
            "{:.3f} m, {:.3f} m beyond the joint's {:.3f} m",
            shape.far_range,
            nearest,
            nearest - shape.near_range,
            shape.near_range)});
  }
  const double joint_x = joint_radius(slope_angle, shape, rim);
  const double slope = std::tan(slope_angle);
  const double joint_y = shape.rim_y - (rim.radius - joint_x) * slope;
  const double radius = joint_x / std::sin(slope_angle);
  const double apex = joint_y - radius * (1.0 - std::cos(slope_angle));
  return Profile{
      {sample_part(
           "apex",
           {0.0, joint_x},
           intervals,
           [&](double x) {
             return x < joint_x ? on_sphere(x, apex, radius) : Node{joint_x, joint_y, slope};
           }),
       sample_part("cone", {joint_x, rim.radius}, intervals, [&](double x) {
         return Node{x, joint_y + slope * (x - joint_x), slope};
       })}};
}

}  // namespace teamsight::mirror
