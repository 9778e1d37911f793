// tests/sim/match/fields.hpp: the league's field without paint, with goals.
#pragma once

#include "geometry/field_model.hpp"

namespace teamsight::sim {

inline FieldModel plain_field() {
  FieldModel field;
  field.length = 22.0;
  field.width = 14.0;
  field.surround = 1.0;
  field.line_width = 0.125;
  field.goals.push_back({"ours", {-11.0, -1.0}, {-11.0, 1.0}, 1.0, 0.5, GoalColour::kNone});
  field.goals.push_back({"theirs", {11.0, 1.0}, {11.0, -1.0}, 1.0, 0.5, GoalColour::kNone});
  return field;
}

}  // namespace teamsight::sim
