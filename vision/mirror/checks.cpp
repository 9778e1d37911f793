// vision/mirror/checks.cpp: the conditions that every mirror must meet.
#include "vision/mirror/checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "vision/mirror/trace.hpp"

namespace teamsight::mirror {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kJointGap = 1e-8;        // m; ten times the precision of a profile.csv kink
constexpr double kJointSlopeJump = 1e-6;  // sends a ray astray by 0.1 mm at 6 m
constexpr double kNodeSlopeJump = 0.1;    // between nodes: ten times that of our sharpest apex

Failure fault(Condition condition, double amount, std::string text) {
  return {condition, amount, std::move(text)};
}

std::optional<Failure> check_node(const Node& node) {
  if (std::isfinite(node.x) && std::isfinite(node.y) && std::isfinite(node.slope) &&
      node.x >= 0.0 && node.y > 0.0) {
    return std::nullopt;
  }
  return fault(Condition::kFunction,
               node.y,
               fmt::format("not a function: no finite point above the pinhole at x = {:.6f} m: "
                           "y = {:.6f} m, slope = {:.6f}",
                           node.x,
                           node.y,
                           node.slope));
}

std::optional<Failure> check_order(const Node& a, const Node& b) {
  if (b.x > a.x) {
    return std::nullopt;
  }
  return fault(
      Condition::kFunction,
      a.x - b.x,
      fmt::format("not a function: x goes back by {:.3g} m behind x = {:.6f} m", a.x - b.x, a.x));
}

std::optional<Failure> check_part(const Part& part) {
  for (std::size_t k = 0; k < part.nodes.size(); ++k) {
    auto failed = check_node(part.nodes[k]);
    if (!failed && k > 0) {
      failed = check_order(part.nodes[k - 1], part.nodes[k]);
    }
    if (failed) {
      return failed;
    }
  }
  return std::nullopt;
}

std::optional<Failure> check_joint(const Part& inner, const Part& outer, Worst& jump) {
  const Node& a = inner.nodes.back();
  const Node& b = outer.nodes.front();
  const double gap = std::hypot(b.x - a.x, b.y - a.y);
  if (gap > kJointGap) {
    return fault(Condition::kFunction,
                 gap,
                 fmt::format("not a function: {} and {} lie {:.3g} m apart at x = {:.6f} m",
                             inner.name,
                             outer.name,
                             gap,
                             a.x));
  }
  const double found = std::abs(b.slope - a.slope);
  if (outer.kinked_start) {
    return std::nullopt;
  }
  if (found > kJointSlopeJump) {
    return fault(Condition::kSlopeJump,
                 found,
                 fmt::format("slope jump: {:.6f} between {} and {} at x = {:.6f} m, at most {:.0e} "
                             "is smooth",
                             found,
                             inner.name,
                             outer.name,
                             a.x,
                             kJointSlopeJump));
  }
  if (found > jump.value) {
    jump = {found, a.x};
  }
  return std::nullopt;
}

std::optional<Failure> check_bends(const Part& part) {
  for (std::size_t k = 1; k < part.nodes.size(); ++k) {
    const Node& a = part.nodes[k - 1];
    const Node& b = part.nodes[k];
    const double chord = (b.y - a.y) / (b.x - a.x);
    const double bend = std::max(std::abs(b.slope - a.slope), std::abs(chord - b.slope));
    if (bend > kNodeSlopeJump * (1.0 + b.slope * b.slope)) {
      return fault(Condition::kSlopeJump,
                   bend,
                   fmt::format("slope jump: {:.4f} inside {} at x = {:.6f} m, at most {:.1f} "
                               "between two points",
                               bend,
                               part.name,
                               b.x,
                               kNodeSlopeJump * (1.0 + b.slope * b.slope)));
    }
  }
  return std::nullopt;
}

std::optional<Failure> check_slopes(const Profile& profile, Worst& jump) {
  for (std::size_t i = 0; i < profile.parts.size(); ++i) {
    auto failed = check_bends(profile.parts[i]);
    if (!failed && i > 0) {
      failed = check_joint(profile.parts[i - 1], profile.parts[i], jump);
    }
    if (failed) {
      return failed;
    }
  }
  return std::nullopt;
}

/// The angle between camera ray and surface: 90 degrees less alpha less gamma.
Worst least_facing(const std::vector<Ray>& rays) {
  Worst worst{kInfinity, 0.0};
  for (const Ray& ray : rays) {
    const double alpha = std::atan2(ray.origin.x, ray.origin.y);
    const double facing = std::numbers::pi / 2.0 - alpha - std::atan(ray.origin.slope);
    if (facing < worst.value) {
      worst = {facing, ray.origin.x};
    }
  }
  return worst;
}

/// The angle between one reflected ray and the lowest direction to the mirror further out.
double second_hit_angle(const std::vector<Ray>& rays, std::size_t i) {
  const Node& from = rays[i].origin;
  const double elevation = rays[i].psi - std::numbers::pi / 2.0;
  double lowest = from.slope;
  for (std::size_t k = i + 1; k < rays.size(); ++k) {
    const Node& to = rays[k].origin;
    if (to.x > from.x) {
      lowest = std::min(lowest, (to.y - from.y) / (to.x - from.x));
    }
  }
  return std::atan(lowest) - elevation;
}

Worst least_second_hit(const std::vector<Ray>& rays) {
  Worst worst{kInfinity, 0.0};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    // A ray turned towards the axis crosses to the other side of the mirror.
    const double angle = rays[i].psi < 0.0 ? rays[i].psi : second_hit_angle(rays, i);
    if (rays[i].origin.x > 0.0 && angle < worst.value) {
      worst = {angle, rays[i].origin.x};
    }
  }
  return worst;
}

/// How far each part's view turns back on the floor, at worst; infinite from beyond the horizon.
Worst most_turned_back(const Assembly& assembly, const std::vector<Ray>& rays) {
  Worst worst;
  double reached = 0.0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double distance = floor_distance(rays[i], assembly.pinhole_height).value_or(kInfinity);
    const bool begins = i == 0 || rays[i].part != rays[i - 1].part;
    reached = begins ? distance : std::max(reached, distance);
    if (distance < kInfinity && reached - distance > worst.value) {
      worst = {reached - distance, rays[i].origin.x};
    }
  }
  return worst;
}

std::optional<Failure> check_floor_order(const Assembly& assembly, const std::vector<Ray>& rays) {
  const Worst back = most_turned_back(assembly, rays);
  if (back.value < 1e-9) {
    return std::nullopt;
  }
  return fault(Condition::kFloorOrder,
               back.value,
               fmt::format("floor seen twice: a part's view turns back by {:.3g} m on the floor, "
                           "up to x = {:.6f} m",
                           back.value,
                           back.x));
}

/// The body's cylinder that comes closest to the ray, for the message.
std::string blame_body(const Ray& ray, const Assembly& assembly, double clearance) {
  const double start = ray.origin.y + assembly.pinhole_height;
  for (const BodyCylinder& cylinder : assembly.body) {
    const double passes = ray.origin.x + (start - cylinder.height) * std::tan(ray.psi);
    if (passes - cylinder.radius <= clearance + 1e-12) {
      return fmt::format(
          "its ray passes {:.4f} m from the axis at height {:.3f} m, where the body "
          "has radius {:.4f} m",
          passes,
          cylinder.height,
          cylinder.radius);
    }
  }
  return {};
}

std::optional<Failure> check_ring(const Assembly& assembly,
                                  const std::vector<Ray>& rays,
                                  std::size_t ring,
                                  std::optional<Worst>& worst) {
  for (const Ray& ray : rays) {
    const double clearance = body_clearance(ray, assembly);
    if (ray.part != ring || !std::isfinite(clearance)) {
      continue;
    }
    if (clearance <= 0.0) {
      return fault(Condition::kRingHidden,
                   -clearance,
                   fmt::format("ring hidden by the body: {}, {:.4f} m too much",
                               blame_body(ray, assembly, clearance),
                               -clearance));
    }
    if (!worst || clearance < worst->value) {
      worst = Worst{clearance, ray.origin.x};
    }
  }
  return std::nullopt;
}

std::vector<Ray> all_rays(const Profile& profile) {
  std::vector<Ray> rays;
  for (std::size_t part = 0; part < profile.parts.size(); ++part) {
    for (const Node& node : profile.parts[part].nodes) {
      rays.push_back(reflect(part, node));
    }
  }
  return rays;
}

/// The conditions on single rays: each one comes from the camera and leaves the mirror for good.
std::optional<Failure> check_rays(const std::vector<Ray>& rays, Margins& margins) {
  margins.facing = least_facing(rays);
  if (margins.facing.value <= 0.0) {
    return fault(Condition::kFacing,
                 -margins.facing.value,
                 fmt::format("hidden from the camera: the surface at x = {:.6f} m is turned away "
                             "by {:.3f} deg",
                             margins.facing.x,
                             -margins.facing.value / kDegree));
  }
  margins.second_hit = least_second_hit(rays);
  if (margins.second_hit.value <= 0.0) {
    return fault(Condition::kSecondHit,
                 -margins.second_hit.value,
                 fmt::format("second hit: the ray from x = {:.6f} m meets the mirror again, "
                             "{:.3f} deg inside it",
                             margins.second_hit.x,
                             -margins.second_hit.value / kDegree));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Failure> check_function(const Profile& profile) {
  for (const Part& part : profile.parts) {
    if (auto failed = check_part(part)) {
      return failed;
    }
  }
  return std::nullopt;
}

Result<Margins, Failure> check(const Assembly& assembly, std::optional<std::size_t> ring) {
  Margins margins;
  auto failed = check_function(assembly.profile);
  if (!failed) {
    failed = check_slopes(assembly.profile, margins.joint_slope_jump);
  }
  if (failed) {
    return failure(*failed);
  }
  const std::vector<Ray> rays = all_rays(assembly.profile);
  failed = check_rays(rays, margins);
  if (!failed) {
    failed = check_floor_order(assembly, rays);
  }
  if (!failed && ring) {
    failed = check_ring(assembly, rays, *ring, margins.ring_clearance);
  }
  if (failed) {
    return failure(*failed);
  }
  return margins;
}

}  // namespace teamsight::mirror
