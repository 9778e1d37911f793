// tests/vision/localisation/fields.hpp: the league's field, without reading a file.
#pragma once

#include <numbers>

#include "geometry/field_model.hpp"

namespace teamsight::vision {

/// The 22 x 14 m field of the rulebook; symmetric under half a turn.
inline FieldModel league_field() {
  FieldModel field;
  field.name = "league";
  field.length = 22.0;
  field.width = 14.0;
  field.surround = 1.0;
  field.line_width = 0.125;
  const auto line = [&](double x1, double y1, double x2, double y2) {
    field.lines.push_back({"line", {x1, y1}, {x2, y2}, LineFamily::kOther});
  };
  line(-11, -7, 11, -7);
  line(-11, 7, 11, 7);
  line(0, -7, 0, 7);
  for (const double side : {-1.0, 1.0}) {
    line(side * 11, -7, side * 11, 7);
    for (const auto& [depth, half] : {std::pair{2.25, 3.45}, std::pair{0.75, 1.95}}) {
      line(side * 11, -half, side * (11 - depth), -half);
      line(side * 11, half, side * (11 - depth), half);
      line(side * (11 - depth), -half, side * (11 - depth), half);
    }
  }
  field.arcs.push_back({"circle", {0, 0}, 2.0, 0.0, 2.0 * std::numbers::pi});
  return field;
}

}  // namespace teamsight::vision
