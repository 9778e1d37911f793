// tests/fuzz/small_field.hpp: a field whose tables are made in no time, also by a sanitizer's
// build.
#pragma once

#include <numbers>

#include "geometry/field_model.hpp"

namespace teamsight::fuzz {

/// 3 x 2 m, with a centre line and circle and boards close around it.
inline FieldModel small_field() {
  FieldModel field;
  field.name = "small";
  field.length = 3.0;
  field.width = 2.0;
  field.surround = 0.3;
  field.line_width = 0.125;
  const auto line = [&](double x1, double y1, double x2, double y2) {
    field.lines.push_back({"line", {x1, y1}, {x2, y2}, LineFamily::kOther});
  };
  line(-1.5, -1, 1.5, -1);
  line(-1.5, 1, 1.5, 1);
  line(-1.5, -1, -1.5, 1);
  line(1.5, -1, 1.5, 1);
  line(0, -1, 0, 1);
  field.arcs.push_back({"circle", {0, 0}, 0.6, 0.0, 2.0 * std::numbers::pi});
  return field;
}

}  // namespace teamsight::fuzz
