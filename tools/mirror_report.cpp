// tools/mirror_report.cpp: the numbers of report.json and of `teamsight mirror trace`.
#include "tools/mirror_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <nlohmann/json.hpp>

namespace teamsight::tools {
namespace {

using Json = nlohmann::ordered_json;
using mirror::Mirror;
using mirror::Node;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::array kDistances{
    0.40, 0.45, 0.50, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0};

Json or_null(std::optional<double> value, double factor = 1.0) {
  return value ? Json(*value * factor) : Json(nullptr);
}

Json point_json(const Node& node, double focal_px) {
  return {{"x_m", node.x},
          {"y_m", node.y},
          {"slope", node.slope},
          {"slope_deg", std::atan(node.slope) / kDegree},
          {"camera_ray_deg", std::atan2(node.x, node.y) / kDegree},
          {"image_radius_px", focal_px * node.x / node.y}};
}

/// Apex curvature of any profile, from its first nodes; nothing if the axis is not on the mirror.
std::optional<double> apex_radius(const mirror::Profile& profile) {
  const auto& nodes = profile.parts.front().nodes;
  const double bend = nodes[1].slope - nodes[0].slope;
  if (nodes[0].x > 0.0 || std::abs(bend) < 1e-12) {
    return std::nullopt;
  }
  return (nodes[1].x - nodes[0].x) / bend;
}

Json split_json(const Mirror& mirror) {
  const double rim_px =
      mirror.assembly.focal_px * rim(mirror.assembly.profile).x / rim(mirror.assembly.profile).y;
  Json parts = Json::array();
  for (const mirror::Part& part : mirror.assembly.profile.parts) {
    const Node& a = part.nodes.front();
    const Node& b = part.nodes.back();
    const double from = mirror.assembly.focal_px * a.x / a.y;
    const double to = mirror.assembly.focal_px * b.x / b.y;
    parts.push_back({{"part", part.name},
                     {"from_px", from},
                     {"to_px", to},
                     {"share_of_radius", (to - from) / rim_px},
                     {"share_of_area", (to * to - from * from) / (rim_px * rim_px)}});
  }
  return parts;
}

Json views_json(const Mirror& mirror, const std::vector<mirror::FloorView>& views) {
  Json result = Json::array();
  for (const mirror::FloorView& view : views) {
    result.push_back({{"part", mirror.assembly.profile.parts[view.part].name},
                      {"near_m", view.near},
                      {"far_m", view.to_horizon ? Json(nullptr) : Json(view.far)}});
  }
  return result;
}

/// Stretches of floor between the nearest and the farthest view that no part shows.
Json gaps_json(std::vector<mirror::FloorView> views) {
  std::sort(
      views.begin(), views.end(), [](const auto& a, const auto& b) { return a.near < b.near; });
  Json gaps = Json::array();
  double reached = views.empty() ? 0.0 : views.front().near;
  for (const mirror::FloorView& view : views) {
    if (view.near > reached + 1e-6) {
      gaps.push_back({{"from_m", reached}, {"to_m", view.near}});
    }
    reached = std::max(reached, view.far);
  }
  return gaps;
}

Json resolution_json(const std::vector<mirror::FloorSample>& samples) {
  Json rows = Json::array();
  for (const double distance : kDistances) {
    rows.push_back({{"distance_m", distance},
                    {"mm_per_px", or_null(mirror::pixel_error(samples, distance), 1e3)}});
  }
  return rows;
}

Json margins_json(const mirror::Margins& margins) {
  return {{"second_hit_margin_deg", margins.second_hit.value / kDegree},
          {"second_hit_at_x_m", margins.second_hit.x},
          {"facing_margin_deg", margins.facing.value / kDegree},
          {"facing_at_x_m", margins.facing.x},
          {"rays_that_hit_twice", 0},  // else there is no mirror to report
          {"joint_slope_jump", margins.joint_slope_jump.value}};
}

void add_multi_part(Json& report, const Mirror& mirror) {
  if (!mirror.multi_part) {
    report["points"] = nullptr;
    report["isometric"] = nullptr;
    report["arc"] = nullptr;
    report["ray_of_B"] = nullptr;
    return;
  }
  const auto& s = *mirror.multi_part;
  const double focal = mirror.assembly.focal_px;
  report["points"] = {{"A", point_json(s.point_A, focal)},
                      {"B", point_json(s.point_B, focal)},
                      {"C", point_json(s.point_C, focal)}};
  report["isometric"] = {{"eta_m", s.isometric.eta},
                         {"mm_per_px", 1e3 * s.isometric.eta / focal},
                         {"range_m", s.isometric.eta * s.isometric.tan_end}};
  const mirror::Ray ray_B = mirror::reflect(1, s.point_B);
  report["ray_of_B"] = {{"distance_m", s.parameters.max_distance},
                        {"height_m",
                         or_null(mirror::height_at(
                             ray_B, mirror.assembly.pinhole_height, s.parameters.max_distance))},
                        {"elevation_deg", ray_B.psi / kDegree - 90.0}};
  const double angle = std::atan(s.point_A.slope);
  const bool is_straight = std::abs(s.arc.curvature) < 1e-9;
  const double radius = is_straight ? 0.0 : 1.0 / s.arc.curvature;
  report["arc"] = {
      {"radius_m", is_straight ? Json(nullptr) : Json(radius)},
      {"centre_x_m", is_straight ? Json(nullptr) : Json(s.point_A.x - radius * std::sin(angle))},
      {"centre_y_m", is_straight ? Json(nullptr) : Json(s.point_A.y + radius * std::cos(angle))}};
}

Json integration_json(const Mirror& mirror) {
  if (!mirror.integrations) {
    return nullptr;
  }
  const auto& d = *mirror.integrations;
  return {{"facets", d.facets},
          {"profile_difference_m", d.profile},
          {"end_slope_difference", d.end_slope},
          {"floor_difference_m", d.ground},
          {"floor_difference_at_m", d.ground_range}};
}

}  // namespace

Json mirror_report(const Mirror& mirror, std::optional<double> pixel_pitch) {
  const mirror::Assembly& assembly = mirror.assembly;
  const Node edge = rim(assembly.profile);
  const auto samples = mirror::sample_floor(assembly);
  const auto views = mirror::visible_floor(samples);
  Json report;
  report["name"] = mirror.name;
  report["rim_radius_m"] = edge.x;
  report["rim_height_m"] = assembly.pinhole_height + edge.y;
  report["pinhole_height_m"] = assembly.pinhole_height;
  report["focal_px"] = assembly.focal_px;
  report["lens_mm"] = pixel_pitch ? Json(assembly.focal_px * *pixel_pitch * 1e3) : Json(nullptr);
  report["field_of_view_deg"] = 2.0 * std::atan2(edge.x, edge.y) / kDegree;
  report["apex_y_m"] = assembly.profile.parts.front().nodes.front().y;
  report["apex_radius_m"] = or_null(apex_radius(assembly.profile));
  add_multi_part(report, mirror);
  report["image_split"] = split_json(mirror);
  report["floor"] = views_json(mirror, views);
  report["unseen_between"] = gaps_json(views);
  report["blind_zone_m"] = or_null(mirror::blind_radius(views));
  report["resolution"] = resolution_json(samples);
  report["self_shadowing"] = margins_json(mirror.margins);
  report["ring_clearance_m"] =
      mirror.margins.ring_clearance ? Json(mirror.margins.ring_clearance->value) : Json(nullptr);
  report["integration"] = integration_json(mirror);
  return report;
}

Json trace_report(const Mirror& mirror, double radius_px, const std::vector<double>& distances) {
  const mirror::Assembly& assembly = mirror.assembly;
  const auto ray = mirror::trace(assembly, radius_px);
  Json line{{"mirror", mirror.name}, {"pixel_radius_px", radius_px}};
  line["part"] = ray ? Json(assembly.profile.parts[ray->part].name) : Json(nullptr);
  line["mirror_x_m"] = ray ? Json(ray->origin.x) : Json(nullptr);
  line["mirror_y_m"] = ray ? Json(ray->origin.y) : Json(nullptr);
  line["elevation_deg"] = ray ? Json(ray->psi / kDegree - 90.0) : Json(nullptr);
  line["ground_distance_m"] =
      ray ? or_null(mirror::floor_distance(*ray, assembly.pinhole_height)) : Json(nullptr);
  line["hidden_by_body"] =
      ray ? Json(mirror::body_clearance(*ray, assembly) <= 0.0) : Json(nullptr);
  Json heights = Json::array();
  for (const double distance : distances) {
    const auto height =
        ray ? mirror::height_at(*ray, assembly.pinhole_height, distance) : std::nullopt;
    heights.push_back({{"distance_m", distance}, {"height_m", or_null(height)}});
  }
  line["heights"] = std::move(heights);
  return line;
}

}  // namespace teamsight::tools
