// tools/svg_plot.hpp: plots of lines over axes as SVG text, several panels side by side.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace teamsight::plot {

/// A point in the units of its panel's axes.
struct Point {
  double x{0.0};
  double y{0.0};
};

/// A polyline. A point that is not finite breaks it; what leaves the axes is cut off.
struct Line {
  std::string label;  ///< in the figure's legend, once per label; empty: not there
  std::string colour{"#333333"};
  std::vector<Point> points;
  double width_px{2.0};
  double opacity{1.0};
  bool is_dashed{false};
};

/// A filled polygon behind the lines.
struct Area {
  std::string colour{"#e6e6e6"};
  std::vector<Point> corners;
};

/// A short text beside a dot, in front of the lines.
struct Mark {
  Point at;
  std::string text;
  double shift_x_px{7.0};   ///< of the text from the dot; to the left of it if negative
  double shift_y_px{-7.0};  ///< down
  std::string colour{"#222222"};
  bool has_dot{true};
};

/// One axis. @invariant low < high; both positive if logarithmic
struct Axis {
  std::string label;  ///< with the unit
  double low{0.0};
  double high{1.0};
  bool is_logarithmic{false};
};

/// One pair of axes and what is drawn in it.
struct Panel {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Area> areas;
  std::vector<Line> lines;
  std::vector<Mark> marks;
  double width_px{640.0};  ///< of the space inside the axes
};

/// A whole drawing: panels row by row, a title above, a legend below the title.
struct Figure {
  std::string title;
  std::string subtitle;  ///< one line that says what to see; may be empty
  std::size_t columns{1};
  double panel_height_px{380.0};  ///< of the space inside the axes
  std::vector<Panel> panels;
};

/// The figure as an SVG document on white ground, readable without any other file.
///
/// @pre at least one panel and one column
[[nodiscard]] std::string to_svg(const Figure& figure);

/// Colours that are told apart by colour-blind people too, and on white.
[[nodiscard]] const std::string& series_colour(std::size_t index);

}  // namespace teamsight::plot
