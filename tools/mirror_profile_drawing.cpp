// tools/mirror_profile_drawing.cpp: the profile with its rays, near the mirror and down to the
// floor.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "tools/mirror_drawing_style.hpp"
#include "tools/mirror_drawings.hpp"
#include "vision/mirror/trace.hpp"

namespace teamsight::tools {
namespace {

using mirror::Mirror;
using plot::Figure;
using plot::Line;
using plot::Panel;
using plot::Point;

constexpr double kMm = 1e3;
constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kRaysPerPart = 5;
constexpr double kMirrorPanelPx = 460.0;
constexpr double kScenePanelPx = 620.0;
constexpr double kClosePanelPx = 440.0;
constexpr double kWidePanelPx = 992.0;  // below the two others
constexpr double kProfileHeightPx = 420.0;

/// A few rays of one part, equally spaced in the image, its ends left out if they are joints.
std::vector<mirror::Ray> rays_of(const Mirror& mirror,
                                 std::size_t part,
                                 std::size_t count = kRaysPerPart) {
  const auto& nodes = mirror.assembly.profile.parts[part].nodes;
  const double from = nodes.front().x / nodes.front().y;
  const double to = nodes.back().x / nodes.back().y;
  std::vector<mirror::Ray> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const auto ray =
        mirror::trace(mirror.assembly, mirror.assembly.focal_px * (from + u * (to - from)));
    if (ray) {
      rays.push_back(*ray);
    }
  }
  return rays;
}

Point along_ray(const mirror::Ray& ray, double length) {
  return {ray.origin.x + length * std::sin(ray.psi), ray.origin.y - length * std::cos(ray.psi)};
}

/// Equal scales on both axes, wide enough for mirror and pinhole; mm.
void fit_mirror(Panel& panel, const mirror::Node& edge, double highest) {
  const double scale =
      std::max(2.5 * edge.x / kMirrorPanelPx, 1.25 * highest / kProfileHeightPx) * kMm;
  panel.x = {
      "distance from the axis [mm]", -scale * kMirrorPanelPx / 2.0, scale * kMirrorPanelPx / 2.0};
  const double low = 0.5 * (highest * kMm - scale * kProfileHeightPx);
  panel.y = {"height over the pinhole [mm]", low, low + scale * kProfileHeightPx};
}

/// The mirror's own matter: between the profile and a flat top.
plot::Area solid(const mirror::Profile& profile, double top) {
  plot::Area area{"#e4e7ec", {}};
  for (const mirror::Part& part : profile.parts) {
    for (const mirror::Node& node : part.nodes) {
      area.corners.push_back({node.x * kMm, node.y * kMm});
    }
  }
  const std::size_t count = area.corners.size();
  area.corners.push_back({area.corners.back().x, top});
  area.corners.push_back({-area.corners.back().x, top});
  for (std::size_t i = count; i-- > 0;) {
    area.corners.push_back({-area.corners[i].x, area.corners[i].y});
  }
  return area;
}

Line surface(const mirror::Part& part, const std::string& colour, double side) {
  Line line{.label = side > 0.0 ? part.name : "", .colour = colour, .points = {}, .width_px = 3.5};
  for (const mirror::Node& node : part.nodes) {
    line.points.push_back({side * node.x * kMm, node.y * kMm});
  }
  return line;
}

void mark_points(Panel& panel, const Mirror& mirror) {
  panel.marks.push_back({{0.0, 0.0}, "pinhole", -9.0, 4.0});
  if (!mirror.multi_part) {
    return;
  }
  const auto& s = *mirror.multi_part;
  panel.marks.push_back({{s.point_A.x * kMm, s.point_A.y * kMm}, "A", -9.0, -8.0});
  panel.marks.push_back({{s.point_B.x * kMm, s.point_B.y * kMm}, "B", -5.0, -11.0});
  panel.marks.push_back({{s.point_C.x * kMm, s.point_C.y * kMm}, "C", 5.0, -10.0});
}

Panel mirror_panel(const Mirror& mirror, PartColours& colours) {
  Panel panel{.title = mirror.name + ": the mirror, to scale",
              .x = {},
              .y = {},
              .areas = {},
              .lines = {},
              .marks = {},
              .width_px = kMirrorPanelPx};
  const auto& profile = mirror.assembly.profile;
  double highest = 0.0;
  for (const mirror::Part& part : profile.parts) {
    highest = std::max(highest, part.nodes.back().y);
  }
  fit_mirror(panel, rim(profile), highest);
  panel.areas.push_back(solid(profile, highest * kMm + 5.0));
  for (std::size_t i = 0; i < profile.parts.size(); ++i) {
    const std::string& colour = colours.of(profile.parts[i].name);
    for (const mirror::Ray& ray : rays_of(mirror, i)) {
      const Point end = along_ray(ray, 1.0);
      panel.lines.push_back({.label = "",
                             .colour = colour,
                             .points = {{0.0, 0.0},
                                        {ray.origin.x * kMm, ray.origin.y * kMm},
                                        {end.x * kMm, end.y * kMm}},
                             .width_px = 1.1,
                             .opacity = 0.75});
    }
  }
  for (const mirror::Part& part : profile.parts) {
    panel.lines.push_back(surface(part, colours.of(part.name), 1.0));
    panel.lines.push_back(surface(part, colours.of(part.name), -1.0));
  }
  mark_points(panel, mirror);
  return panel;
}

/// Down to the floor, or to the body, or out of the picture.
Line scene_ray(const Mirror& mirror, const mirror::Ray& ray, const std::string& colour) {
  const double start = mirror.assembly.pinhole_height + ray.origin.y;
  const bool is_hidden = mirror::body_clearance(ray, mirror.assembly) <= 0.0;
  const auto floor = mirror::floor_distance(ray, mirror.assembly.pinhole_height);
  const double length = floor ? start / std::cos(ray.psi) : 100.0;
  const Point end = along_ray(ray, length);
  return {.label = is_hidden ? "hidden by the body" : "",
          .colour = is_hidden ? "#999999" : colour,
          .points = {{ray.origin.x, start}, {end.x, end.y + mirror.assembly.pinhole_height}},
          .width_px = 1.3,
          .opacity = 0.9,
          .is_dashed = is_hidden};
}

void add_scene(Panel& panel, const Mirror& mirror, PartColours& colours, std::size_t rays) {
  for (const auto& [height, radius] : mirror.assembly.body) {
    panel.areas.push_back(
        {"#c9ced6", {{0.0, 0.0}, {0.0, height}, {radius, height}, {radius, 0.0}}});
  }
  const auto& parts = mirror.assembly.profile.parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const mirror::Ray& ray : rays_of(mirror, i, rays)) {
      panel.lines.push_back(scene_ray(mirror, ray, colours.of(parts[i].name)));
    }
  }
}

Panel scene_panel(const Mirror& mirror, PartColours& colours, double width_px) {
  const double top = mirror.assembly.pinhole_height + rim(mirror.assembly.profile).y;
  Panel panel{.title = mirror.name + ": the floor it sees (heights enlarged)",
              .x = {"distance from the axis [m]", 0.0, farthest({mirror})},
              .y = {"height over the floor [m]", 0.0, 1.15 * top},
              .areas = {},
              .lines = {},
              .marks = {},
              .width_px = width_px};
  add_scene(panel, mirror, colours, kRaysPerPart);
  return panel;
}

/// The robot's neighbourhood to scale, with the floor that nothing shows.
Panel close_panel(const Mirror& mirror, PartColours& colours) {
  const double top = 1.15 * (mirror.assembly.pinhole_height + rim(mirror.assembly.profile).y);
  Panel panel{.title = mirror.name + ": beside the robot, to scale",
              .x = {"distance from the axis [m]", 0.0, top * kClosePanelPx / kProfileHeightPx},
              .y = {"height over the floor [m]", 0.0, top},
              .areas = {},
              .lines = {},
              .marks = {},
              .width_px = kClosePanelPx};
  add_scene(panel, mirror, colours, 2 * kRaysPerPart);
  const auto blind =
      mirror::blind_radius(mirror::visible_floor(mirror::sample_floor(mirror.assembly)));
  if (blind) {
    panel.lines.push_back({.label = "floor that nothing shows",
                           .colour = "#b00020",
                           .points = {{0.0, 0.004}, {*blind, 0.004}},
                           .width_px = 5.0});
    panel.marks.push_back(
        {{*blind, 0.004}, fmt::format("blind up to {:.2f} m", *blind), 70.0, -10.0, "#b00020"});
  }
  return panel;
}

/// The ray through B, with the height it was designed for.
void add_farthest_ray(Panel& panel, const Mirror& mirror) {
  if (!mirror.multi_part) {
    return;
  }
  const mirror::Ray ray = mirror::reflect(1, mirror.multi_part->point_B);
  const auto height = [&](double distance) {
    return mirror::height_at(ray, mirror.assembly.pinhole_height, distance).value_or(kNowhere);
  };
  panel.lines.push_back({.label = "ray of B",
                         .colour = "#222222",
                         .points = {{ray.origin.x, height(ray.origin.x)},
                                    {farthest({mirror}), height(farthest({mirror}))}},
                         .width_px = 1.8});
  const double shown = mirror.multi_part->parameters.max_distance;
  panel.marks.push_back({{shown, height(shown)},
                         fmt::format("{:.3f} m at {:g} m", height(shown), shown),
                         -6.0,
                         20.0});
}

}  // namespace

Figure profile_figure(const std::vector<Mirror>& mirrors) {
  Figure figure{
      .title = title_of(mirrors, "Profile and rays"),
      .subtitle = "The rays of a part are equally spaced in the image; the robot's body is grey.",
      .columns = 2,
      .panel_height_px = kProfileHeightPx,
      .panels = {}};
  PartColours colours;
  for (const Mirror& mirror : mirrors) {
    figure.panels.push_back(mirror_panel(mirror, colours));
    if (mirrors.size() == 1) {
      figure.panels.push_back(close_panel(mirror, colours));
    }
    figure.panels.push_back(
        scene_panel(mirror, colours, mirrors.size() == 1 ? kWidePanelPx : kScenePanelPx));
    add_farthest_ray(figure.panels.back(), mirror);
  }
  return figure;
}

}  // namespace teamsight::tools
