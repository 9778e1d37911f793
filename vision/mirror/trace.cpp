// vision/mirror/trace.cpp: reflection in the meridian plane and what it shows of the floor.
#include "vision/mirror/trace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace teamsight::mirror {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2.0;

/// The slope in `at` of the parabola through three points.
double parabola_slope(const FloorSample& at, const FloorSample& b, const FloorSample& c) {
  const double to_b = b.radius_px - at.radius_px;
  const double to_c = c.radius_px - at.radius_px;
  const double slope_b = (*b.distance - *at.distance) / to_b;
  const double slope_c = (*c.distance - *at.distance) / to_c;
  return (slope_b * to_c - slope_c * to_b) / (to_c - to_b);
}

/// From the two nearest samples of the same part; nothing where the part shows less floor.
std::optional<double> scale_at(const std::vector<FloorSample>& samples, std::size_t i) {
  const auto is_usable = [&](std::size_t k) {
    return k < samples.size() && samples[k].part == samples[i].part && samples[k].distance;
  };
  if (!is_usable(i)) {
    return std::nullopt;
  }
  const bool has_below = i >= 1 && is_usable(i - 1);
  const bool has_above = is_usable(i + 1);
  if (has_below && has_above) {
    return std::abs(parabola_slope(samples[i], samples[i - 1], samples[i + 1]));
  }
  if (has_above && is_usable(i + 2)) {
    return std::abs(parabola_slope(samples[i], samples[i + 1], samples[i + 2]));
  }
  if (has_below && i >= 2 && is_usable(i - 2)) {
    return std::abs(parabola_slope(samples[i], samples[i - 1], samples[i - 2]));
  }
  return std::nullopt;
}

/// Between a hidden and a visible sample: the distance at which the clearance vanishes.
double border(const FloorSample& a, const FloorSample& b) {
  const double u = a.clearance / (a.clearance - b.clearance);
  return *a.distance + u * (*b.distance - *a.distance);
}

bool are_joined(const FloorSample& a, const FloorSample& b) {
  return a.part == b.part && a.distance && b.distance && std::isfinite(a.clearance) &&
         std::isfinite(b.clearance);
}

void extend(FloorView& view, double distance) {
  view.near = std::min(view.near, distance);
  view.far = std::max(view.far, distance);
}

}  // namespace

double reflected_angle(double alpha, double slope) {
  return alpha + 2.0 * std::atan(slope);
}

Ray reflect(std::size_t part, const Node& node) {
  return {part, node, reflected_angle(std::atan2(node.x, node.y), node.slope)};
}

std::optional<Ray> trace(const Assembly& assembly, double radius_px) {
  const auto hit = find_hit(assembly.profile, radius_px / assembly.focal_px);
  if (!hit) {
    return std::nullopt;
  }
  return reflect(hit->part, hit->node);
}

std::optional<double> floor_distance(const Ray& ray, double pinhole_height) {
  if (std::abs(ray.psi) >= kRightAngle - 1e-9) {
    return std::nullopt;
  }
  return ray.origin.x + (ray.origin.y + pinhole_height) * std::tan(ray.psi);
}

std::optional<double> height_at(const Ray& ray, double pinhole_height, double distance) {
  if (distance < ray.origin.x || std::sin(ray.psi) <= 0.0) {
    return std::nullopt;
  }
  const double fall = (distance - ray.origin.x) * std::cos(ray.psi) / std::sin(ray.psi);
  const double height = ray.origin.y + pinhole_height - fall;
  return height >= 0.0 ? std::optional(height) : std::nullopt;
}

double body_clearance(const Ray& ray, const Assembly& assembly) {
  double clearance = std::numeric_limits<double>::infinity();
  if (std::abs(ray.psi) >= kRightAngle) {
    return clearance;
  }
  const double start = ray.origin.y + assembly.pinhole_height;
  for (const BodyCylinder& cylinder : assembly.body) {
    if (cylinder.height < start) {
      const double passes = ray.origin.x + (start - cylinder.height) * std::tan(ray.psi);
      clearance = std::min(clearance, std::abs(passes) - cylinder.radius);
    }
  }
  return clearance;
}

std::vector<FloorSample> sample_floor(const Assembly& assembly) {
  std::vector<FloorSample> samples;
  for (std::size_t part = 0; part < assembly.profile.parts.size(); ++part) {
    for (const Node& node : assembly.profile.parts[part].nodes) {
      const Ray ray = reflect(part, node);
      samples.push_back({.part = part,
                         .node = node,
                         .radius_px = assembly.focal_px * node.x / node.y,
                         .distance = floor_distance(ray, assembly.pinhole_height),
                         .m_per_px = std::nullopt,
                         .clearance = body_clearance(ray, assembly)});
    }
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].m_per_px = scale_at(samples, i);
  }
  return samples;
}

std::vector<FloorView> visible_floor(const std::vector<FloorSample>& samples) {
  std::vector<FloorView> views;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const FloorSample& now = samples[i];
    const FloorSample* const before =
        i > 0 && samples[i - 1].part == now.part ? &samples[i - 1] : nullptr;
    const bool follows = before != nullptr && before->is_visible();
    if (now.is_visible() && !follows) {
      views.push_back({now.part, *now.distance, *now.distance, false});
    }
    if (now.is_visible()) {
      extend(views.back(), *now.distance);
    } else if (follows && !now.distance) {
      views.back().to_horizon = true;
    }
    if (before != nullptr && follows != now.is_visible() && are_joined(*before, now)) {
      extend(views.back(), border(*before, now));
    }
  }
  return views;
}

std::optional<double> blind_radius(const std::vector<FloorView>& views) {
  if (views.empty()) {
    return std::nullopt;
  }
  return std::min_element(views.begin(),
                          views.end(),
                          [](const FloorView& a, const FloorView& b) { return a.near < b.near; })
      ->near;
}

std::optional<double> pixel_error(const std::vector<FloorSample>& samples, double distance) {
  std::optional<double> best;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const FloorSample& a = samples[i - 1];
    const FloorSample& b = samples[i];
    if (a.part != b.part || !a.is_visible() || !b.is_visible() || !a.m_per_px || !b.m_per_px) {
      continue;
    }
    const double span = *b.distance - *a.distance;
    const double u = (distance - *a.distance) / span;
    if (u >= -1e-9 && u <= 1.0 + 1e-9) {
      const double here = *a.m_per_px + u * (*b.m_per_px - *a.m_per_px);
      best = std::min(best.value_or(here), here);
    }
  }
  return best;
}

}  // namespace teamsight::mirror
