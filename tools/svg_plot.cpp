// tools/svg_plot.cpp: layout and elements of the drawings.
#include "tools/svg_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "tools/svg_ticks.hpp"

namespace teamsight::plot {
namespace {

constexpr double kLeft = 68.0;  // px around the axes of a panel
constexpr double kRight = 24.0;
constexpr double kTop = 34.0;
constexpr double kBottom = 54.0;
constexpr double kLegendRow = 22.0;
constexpr double kMargin = 18.0;

/// A panel's place on the paper.
struct Box {
  double x{0.0};
  double y{0.0};
  double width{0.0};
  double height{0.0};
};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

class Writer {
 public:
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

Point to_paper(const Panel& panel, const Box& box, const Point& point) {
  return {box.x + box.width * along(panel.x, point.x),
          box.y + box.height * (1.0 - along(panel.y, point.y))};
}

bool is_drawable(const Point& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::abs(p.x) < 1e5 && std::abs(p.y) < 1e5;
}

void draw_grid(Writer& svg, const Panel& panel, const Box& box) {
  for (const double value : ticks(panel.x, std::max(3, static_cast<int>(box.width / 70.0)))) {
    const double x = box.x + box.width * along(panel.x, value);
    svg.add(R"(<line class="grid" x1="{0:.1f}" x2="{0:.1f}" y1="{1:.1f}" y2="{2:.1f}"/>)",
            x,
            box.y,
            box.y + box.height);
    svg.add(R"(<text class="tick" x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)",
            x,
            box.y + box.height + 17.0,
            tick_text(value));
  }
  for (const double value : ticks(panel.y, std::max(3, static_cast<int>(box.height / 50.0)))) {
    const double y = box.y + box.height * (1.0 - along(panel.y, value));
    svg.add(R"(<line class="grid" x1="{0:.1f}" x2="{1:.1f}" y1="{2:.1f}" y2="{2:.1f}"/>)",
            box.x,
            box.x + box.width,
            y);
    svg.add(R"(<text class="tick" x="{:.1f}" y="{:.1f}" text-anchor="end">{}</text>)",
            box.x - 8.0,
            y + 4.0,
            tick_text(value));
  }
}

void draw_labels(Writer& svg, const Panel& panel, const Box& box) {
  svg.add(R"(<rect class="frame" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)",
          box.x,
          box.y,
          box.width,
          box.height);
  svg.add(R"(<text class="panel" x="{:.1f}" y="{:.1f}">{}</text>)",
          box.x,
          box.y - 10.0,
          escaped(panel.title));
  svg.add(R"(<text class="axis" x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)",
          box.x + box.width / 2.0,
          box.y + box.height + 38.0,
          escaped(panel.x.label));
  svg.add(
      R"svg(<text class="axis" transform="translate({:.1f},{:.1f}) rotate(-90)" text-anchor="middle">{}</text>)svg",
      box.x - 48.0,
      box.y + box.height / 2.0,
      escaped(panel.y.label));
}

void draw_area(Writer& svg, const Panel& panel, const Box& box, const Area& area) {
  std::string points;
  for (const Point& corner : area.corners) {
    const Point p = to_paper(panel, box, corner);
    points += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  }
  svg.add(R"(<polygon points="{}" fill="{}"/>)", points, area.colour);
}

void draw_line(Writer& svg, const Panel& panel, const Box& box, const Line& line) {
  std::string path;
  bool is_open = false;
  Point last{};
  for (const Point& point : line.points) {
    const Point p = to_paper(panel, box, point);
    if (!is_drawable(p)) {
      is_open = false;
      continue;
    }
    if (is_open && std::hypot(p.x - last.x, p.y - last.y) < 0.4 && &point != &line.points.back()) {
      continue;  // nobody sees it, and the file stays small
    }
    path += fmt::format("{}{:.1f} {:.1f}", is_open ? 'L' : 'M', p.x, p.y);
    is_open = true;
    last = p;
  }
  svg.add(R"(<path d="{}" fill="none" stroke="{}" stroke-width="{}" stroke-opacity="{}"{}/>)",
          path,
          line.colour,
          line.width_px,
          line.opacity,
          line.is_dashed ? R"( stroke-dasharray="5 4")" : "");
}

void draw_mark(Writer& svg, const Panel& panel, const Box& box, const Mark& mark) {
  const Point p = to_paper(panel, box, mark.at);
  if (!is_drawable(p)) {
    return;
  }
  if (mark.has_dot) {
    svg.add(R"(<circle cx="{:.1f}" cy="{:.1f}" r="3.6" fill="{}" stroke="#ffffff"/>)",
            p.x,
            p.y,
            mark.colour);
  }
  svg.add(R"(<text class="mark" x="{:.1f}" y="{:.1f}" style="fill:{}" text-anchor="{}">{}</text>)",
          p.x + mark.shift_x_px,
          p.y + mark.shift_y_px,
          mark.colour,
          mark.shift_x_px < 0.0 ? "end" : "start",
          escaped(mark.text));
}

void draw_panel(Writer& svg, const Panel& panel, const Box& box, std::size_t index) {
  svg.add(
      R"(<clipPath id="panel{}"><rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/></clipPath>)",
      index,
      box.x,
      box.y,
      box.width,
      box.height);
  draw_grid(svg, panel, box);
  svg.add(R"svg(<g clip-path="url(#panel{})">)svg", index);
  for (const Area& area : panel.areas) {
    draw_area(svg, panel, box, area);
  }
  for (const Line& line : panel.lines) {
    draw_line(svg, panel, box, line);
  }
  svg.add("</g>");
  draw_labels(svg, panel, box);
  for (const Mark& mark : panel.marks) {
    draw_mark(svg, panel, box, mark);
  }
}

void add_to_legend(std::vector<Line>& legend, const Line& line) {
  const bool is_known = std::any_of(
      legend.begin(), legend.end(), [&](const Line& known) { return known.label == line.label; });
  if (!line.label.empty() && !is_known) {
    legend.push_back({.label = line.label,
                      .colour = line.colour,
                      .points = {},
                      .width_px = line.width_px,
                      .is_dashed = line.is_dashed});
  }
}

/// The lines that the legend names, each label once.
std::vector<Line> legend_of(const Figure& figure) {
  std::vector<Line> legend;
  for (const Panel& panel : figure.panels) {
    for (const Line& line : panel.lines) {
      add_to_legend(legend, line);
    }
  }
  return legend;
}

double label_width(const std::string& label) {
  return 62.0 + 7.3 * static_cast<double>(label.size());
}

/// Draws the legend in rows; @return the y below it
double draw_legend(Writer& svg, const Figure& figure, double y, double width) {
  const std::vector<Line> legend = legend_of(figure);
  double x = kMargin;
  for (const Line& line : legend) {
    if (x > kMargin && x + label_width(line.label) > width) {
      x = kMargin;
      y += kLegendRow;
    }
    svg.add(R"(<path d="M{:.1f} {:.1f}h28" stroke="{}" stroke-width="{}"{}/>)",
            x,
            y - 4.0,
            line.colour,
            std::max(line.width_px, 2.0),
            line.is_dashed ? R"( stroke-dasharray="5 4")" : "");
    svg.add(R"(<text class="legend" x="{:.1f}" y="{:.1f}">{}</text>)",
            x + 36.0,
            y,
            escaped(line.label));
    x += label_width(line.label);
  }
  return legend.empty() ? y - kLegendRow : y;
}

double figure_width(const Figure& figure) {
  double widest = 0.0;
  double row = 0.0;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    row = (i % figure.columns == 0 ? 0.0 : row) + kLeft + figure.panels[i].width_px + kRight;
    widest = std::max(widest, row);
  }
  return widest + 2.0 * kMargin;
}

constexpr const char* kStyle =
    "<style>text{font-family:'DejaVu Sans',Verdana,Helvetica,Arial,sans-serif;fill:#222}"
    ".title{font-size:20px;font-weight:bold}.subtitle{font-size:13px;fill:#555}"
    ".panel{font-size:14px;font-weight:bold}.axis{font-size:13px}.tick{font-size:12px;fill:#444}"
    ".legend{font-size:13px}.mark{font-size:12px;paint-order:stroke;stroke:#fff;stroke-width:3px}"
    ".grid{stroke:#e3e3e3;stroke-width:1}.frame{fill:none;stroke:#888;stroke-width:1}</style>";

}  // namespace

std::string to_svg(const Figure& figure) {
  const double width = figure_width(figure);
  Writer body;
  double y = 34.0;
  body.add(R"(<text class="title" x="{}" y="{}">{}</text>)", kMargin, y, escaped(figure.title));
  if (!figure.subtitle.empty()) {
    y += 22.0;
    body.add(
        R"(<text class="subtitle" x="{}" y="{}">{}</text>)", kMargin, y, escaped(figure.subtitle));
  }
  y = draw_legend(body, figure, y + 28.0, width) + 8.0;
  double x = kMargin;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    if (i > 0 && i % figure.columns == 0) {
      x = kMargin;
      y += kTop + figure.panel_height_px + kBottom;
    }
    const Panel& panel = figure.panels[i];
    draw_panel(body, panel, {x + kLeft, y + kTop, panel.width_px, figure.panel_height_px}, i);
    x += kLeft + panel.width_px + kRight;
  }
  y += kTop + figure.panel_height_px + kBottom + 6.0;
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" viewBox="0 0 {0:.0f} {1:.0f}">)"
      "\n{2}\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{3}</svg>\n",
      width,
      y,
      kStyle,
      body.text());
}

const std::string& series_colour(std::size_t index) {
  static const std::array<std::string, 8> colours{
      "#0072B2", "#D55E00", "#009E73", "#AA4499", "#E69F00", "#56B4E9", "#882255", "#555555"};
  return colours.at(index % colours.size());
}

}  // namespace teamsight::plot
