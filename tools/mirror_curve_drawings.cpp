// tools/mirror_curve_drawings.cpp: floor distance and pixel error as curves.
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
constexpr double kWidthPx = 760.0;
constexpr double kHeightPx = 420.0;
constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

using Samples = std::vector<mirror::FloorSample>;

/// What one part shows over the image radius: what is seen, or what the body hides.
Line distance_line(const Samples& samples, std::size_t part, bool is_seen) {
  Line line{.label = "", .points = {}, .width_px = is_seen ? 2.6 : 1.4, .is_dashed = !is_seen};
  for (const mirror::FloorSample& sample : samples) {
    if (sample.part == part) {
      const bool is_here = sample.is_visible() == is_seen;
      line.points.push_back(
          {sample.radius_px, is_here ? sample.distance.value_or(kNowhere) : kNowhere});
    }
  }
  return line;
}

Line error_line(const Samples& samples, std::size_t part) {
  Line line{.label = "", .points = {}, .width_px = 2.6};
  for (const mirror::FloorSample& sample : samples) {
    if (sample.part == part && sample.is_visible() && sample.m_per_px) {
      line.points.push_back({*sample.distance, *sample.m_per_px * kMm});
    }
  }
  return line;
}

/// The lines of one part; the last one stands for it in the legend.
std::vector<Line> distance_lines(const Samples& samples, std::size_t part) {
  return {distance_line(samples, part, false), distance_line(samples, part, true)};
}

std::vector<Line> error_lines(const Samples& samples, std::size_t part) {
  return {error_line(samples, part)};
}

/// Appends lines with one colour; the last one gets the label.
void append(std::vector<Line>& all, std::vector<Line> lines, const Line& style) {
  lines.back().label = style.label;
  for (Line& line : lines) {
    line.colour = style.colour;
    all.push_back(std::move(line));
  }
}

/// One mirror: its parts differ in colour. Several: the mirrors do, and the parts have no names.
template <class LinesOf>
std::vector<Line> coloured(const std::vector<Mirror>& mirrors, LinesOf lines_of) {
  std::vector<Line> result;
  for (std::size_t i = 0; i < mirrors.size(); ++i) {
    const Samples samples = mirror::sample_floor(mirrors[i].assembly);
    const auto& parts = mirrors[i].assembly.profile.parts;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const bool is_alone = mirrors.size() == 1;
      append(result,
             lines_of(samples, k),
             {.label = is_alone ? parts[k].name : mirrors[i].name,
              .colour = plot::series_colour(is_alone ? k : i),
              .points = {}});
    }
  }
  return result;
}

double widest_image(const std::vector<Mirror>& mirrors) {
  double widest = 0.0;
  for (const Mirror& mirror : mirrors) {
    const mirror::Node& edge = rim(mirror.assembly.profile);
    widest = std::max(widest, mirror.assembly.focal_px * edge.x / edge.y);
  }
  return widest;
}

void mark_image_radii(Panel& panel, const Mirror& mirror) {
  if (!mirror.multi_part) {
    return;
  }
  const auto& s = *mirror.multi_part;
  for (const auto& [name, node] :
       {std::pair{"A", s.point_A}, std::pair{"B", s.point_B}, std::pair{"C", s.point_C}}) {
    const double radius = mirror.assembly.focal_px * node.x / node.y;
    panel.lines.push_back({.label = "",
                           .colour = "#888888",
                           .points = {{radius, 0.0}, {radius, panel.y.high}},
                           .width_px = 1.0,
                           .is_dashed = true});
    panel.marks.push_back({{radius, 0.25 * panel.y.high},
                           fmt::format("{} {:.0f}", name, radius),
                           radius > 0.9 * panel.x.high ? -5.0 : 5.0,
                           0.0,
                           "#444444",
                           false});
  }
}

void widen(plot::Axis& axis, const Line& line, double distance) {
  for (const Point& point : line.points) {
    if (point.x <= distance && point.y > 0.0) {
      axis.low = std::min(axis.low, point.y / 1.5);
      axis.high = std::max(axis.high, point.y * 1.5);
    }
  }
}

/// Wide enough for what is drawn up to `distance`.
plot::Axis error_axis(const std::vector<Line>& lines, double distance) {
  plot::Axis axis{"one pixel means [mm], logarithmic", 10.0, 100.0, true};
  for (const Line& line : lines) {
    widen(axis, line, distance);
  }
  return axis;
}

}  // namespace

Figure distance_figure(const std::vector<Mirror>& mirrors) {
  Panel panel{.title = "",
              .x = {"distance from the image centre [px]", 0.0, 1.02 * widest_image(mirrors)},
              .y = {"distance on the floor [m]", 0.0, farthest(mirrors)},
              .areas = {},
              .lines = coloured(mirrors, distance_lines),
              .marks = {},
              .width_px = kWidthPx};
  if (mirrors.size() == 1) {
    mark_image_radii(panel, mirrors.front());
  }
  return {
      .title = title_of(mirrors, "Floor distance over image radius"),
      .subtitle = "A straight line is a constant scale. Dashed: hidden by the robot's own body.",
      .columns = 1,
      .panel_height_px = kHeightPx,
      .panels = {std::move(panel)}};
}

Figure pixel_error_figure(const std::vector<Mirror>& mirrors) {
  std::vector<Line> lines = coloured(mirrors, error_lines);
  const plot::Axis axis = error_axis(lines, farthest(mirrors));
  Panel panel{.title = "",
              .x = {"distance on the floor [m]", 0.0, farthest(mirrors)},
              .y = axis,
              .areas = {},
              .lines = std::move(lines),
              .marks = {},
              .width_px = kWidthPx};
  return {
      .title = title_of(mirrors, "What one pixel means on the floor"),
      .subtitle = "How far apart neighbouring pixels look on the floor, outwards. Lower is finer.",
      .columns = 1,
      .panel_height_px = kHeightPx,
      .panels = {std::move(panel)}};
}

}  // namespace teamsight::tools
