// tests/geometry/fields.hpp: a small field with everything in it that has a shape of its own.
#pragma once

#include <numbers>

#include "geometry/field_model.hpp"

namespace teamsight {

inline FieldModel small_field() {
  constexpr double kPi = std::numbers::pi;
  FieldModel field;
  field.name = "small";
  field.length = 10.0;
  field.width = 6.0;
  field.surround = 0.5;
  field.line_width = 0.1;
  field.lines = {{"left", {-5, 3}, {5, 3}, LineFamily::kHorizontal},
                 {"right", {-5, -3}, {5, -3}, LineFamily::kHorizontal},
                 {"own", {-5, 3}, {-5, -3}, LineFamily::kVertical},
                 {"opponent", {5, 3}, {5, -3}, LineFamily::kVertical},
                 {"centre", {0, 3}, {0, -3}, LineFamily::kVertical}};
  field.arcs = {{"circle", {0, 0}, 1.0, 0.0, 2.0 * kPi},
                {"own right corner", {-5, -3}, 0.5, 0.0, 0.5 * kPi},
                {"opponent left corner", {5, 3}, 0.5, kPi, 0.5 * kPi}};
  field.spots = {{"mark", {0, 0}, 0.1}};
  field.goals = {{"goal", {5, 1}, {5, -1}, 1.0, 0.5, GoalColour::kBlue}};
  field.walls = {{"wall", {-5, 4}, {5, 4}, 0.5}};
  return field;
}

}  // namespace teamsight
