// tools/unknown_field.hpp: a field for images of which nobody knows where they were taken.
#pragma once

#include "geometry/field_model.hpp"

namespace teamsight::tools {

/// A field with one far-off line: no posture fits it.
[[nodiscard]] inline FieldModel unknown_field() {
  FieldModel field;
  field.name = "unknown";
  field.length = 1.0;
  field.width = 1.0;
  field.line_width = 0.125;
  field.lines.push_back({"none", {1e4, 0.0}, {1e4, 1.0}, LineFamily::kOther});
  return field;
}

}  // namespace teamsight::tools
