// settings/field_file.cpp: a field file's letters and shapes become a FieldModel.
#include <cmath>
#include <numbers>

#include "config.pb.h"
#include "settings/load.hpp"
#include "settings/text_format.hpp"

namespace teamsight::settings {

namespace {

using config::FieldFile;

constexpr double kTurn = 2.0 * std::numbers::pi;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

Point<Field> point(const config::Point2& p) {
  return {p.x_m(), p.y_m()};
}

LineFamily family_of(FieldFile::Family family) {
  switch (family) {
    case FieldFile::VERTICAL:
      return LineFamily::kVertical;
    case FieldFile::HORIZONTAL:
      return LineFamily::kHorizontal;
    case FieldFile::OTHER:
      break;
  }
  return LineFamily::kOther;
}

GoalColour colour_of(FieldFile::Colour colour) {
  switch (colour) {
    case FieldFile::BLUE:
      return GoalColour::kBlue;
    case FieldFile::YELLOW:
      return GoalColour::kYellow;
    case FieldFile::WHITE:
      return GoalColour::kWhite;
    case FieldFile::NONE:
      break;
  }
  return GoalColour::kNone;
}

// ---- the rulebook's letters --------------------------------------------------------------------

// One half of the field: `side` is -1 for the own one, +1 for the opponent's.
struct Half {
  std::string owner;
  double side;
};

void add_vertical(FieldModel& field, const std::string& name, double x, double half_width) {
  field.lines.push_back({name, {x, half_width}, {x, -half_width}, LineFamily::kVertical});
}

void add_horizontal(FieldModel& field, const std::string& name, double y, double x1, double x2) {
  field.lines.push_back({name, {x1, y}, {x2, y}, LineFamily::kHorizontal});
}

// The three sides of a box in front of a goal; the fourth is the goal line.
void add_area(FieldModel& field, const Half& half, const char* what, double length, double width) {
  if (length <= 0.0 || width <= 0.0) return;
  const std::string name = half.owner + " " + what;
  const double goal_line = half.side * 0.5 * field.length;
  const double front = goal_line - half.side * length;
  add_vertical(field, name + " front", front, 0.5 * width);
  add_horizontal(field, name + " left side", 0.5 * width, goal_line, front);
  add_horizontal(field, name + " right side", -0.5 * width, goal_line, front);
}

void add_corner_arcs(FieldModel& field, const Half& half, double radius) {
  if (radius <= 0.0) return;
  const double x = half.side * 0.5 * field.length;
  const double y = 0.5 * field.width;
  const double quarter = 0.25 * kTurn;
  // The quarter that points into the field starts at -90 or 180 degrees seen from the left corner.
  const double left_start = half.side > 0.0 ? 2.0 * quarter : 3.0 * quarter;
  const double right_start = half.side > 0.0 ? quarter : 0.0;
  field.arcs.push_back({half.owner + " left corner", {x, y}, radius, left_start, quarter});
  field.arcs.push_back({half.owner + " right corner", {x, -y}, radius, right_start, quarter});
}

void add_half(FieldModel& field, const FieldFile::Rulebook& letters, const Half& half) {
  add_vertical(field, half.owner + " goal line", half.side * 0.5 * field.length, 0.5 * field.width);
  add_area(field, half, "goal area", letters.goal_area_length_m(), letters.goal_area_width_m());
  add_area(
      field, half, "penalty area", letters.penalty_area_length_m(), letters.penalty_area_width_m());
  add_corner_arcs(field, half, letters.corner_arc_radius_m());
  const double goal_x = half.side * 0.5 * field.length;
  if (letters.penalty_spot_distance_m() > 0.0) {
    field.spots.push_back({half.owner + " penalty mark",
                           {goal_x - half.side * letters.penalty_spot_distance_m(), 0.0},
                           letters.spot_radius_m()});
  }
  if (letters.goal_width_m() > 0.0) {
    const double left = half.side * 0.5 * letters.goal_width_m();  // as seen from the field
    field.goals.push_back(
        {half.owner + " goal",
         {goal_x, left},
         {goal_x, -left},
         letters.goal_height_m(),
         letters.goal_depth_m(),
         colour_of(half.side < 0.0 ? letters.goal_colour_own() : letters.goal_colour_opponent())});
  }
}

void add_rulebook(FieldModel& field, const FieldFile::Rulebook& letters) {
  if (letters.side_lines()) {
    add_horizontal(
        field, "left side line", 0.5 * field.width, -0.5 * field.length, 0.5 * field.length);
    add_horizontal(
        field, "right side line", -0.5 * field.width, -0.5 * field.length, 0.5 * field.length);
  }
  if (letters.centre_line()) add_vertical(field, "centre line", 0.0, 0.5 * field.width);
  add_half(field, letters, {"own", -1.0});
  add_half(field, letters, {"opponent", 1.0});
  if (letters.centre_circle_radius_m() > 0.0) {
    field.arcs.push_back(
        {"centre circle", {0.0, 0.0}, letters.centre_circle_radius_m(), 0.0, kTurn});
    field.spots.push_back({"centre mark", {0.0, 0.0}, letters.spot_radius_m()});
  }
}

// ---- free shapes -------------------------------------------------------------------------------

void add_shapes(FieldModel& field, const FieldFile& file) {
  for (const auto& line : file.line()) {
    field.lines.push_back(
        {line.name(), point(line.from()), point(line.to()), family_of(line.family())});
  }
  for (const auto& arc : file.arc()) {
    field.arcs.push_back({arc.name(),
                          point(arc.centre()),
                          arc.radius_m(),
                          radians(arc.start_deg()),
                          radians(arc.sweep_deg())});
  }
  for (const auto& spot : file.spot()) {
    field.spots.push_back({spot.name(), point(spot.centre()), spot.radius_m()});
  }
  for (const auto& goal : file.goal()) {
    field.goals.push_back({goal.name(),
                           point(goal.left_post()),
                           point(goal.right_post()),
                           goal.height_m(),
                           goal.depth_m(),
                           colour_of(goal.colour())});
  }
  for (const auto& wall : file.wall()) {
    field.walls.push_back({wall.name(), point(wall.from()), point(wall.to()), wall.height_m()});
  }
}

// ---- checks ------------------------------------------------------------------------------------

void check_length(const TextFile& text,
                  const std::string& key,
                  const config::Point2& from,
                  const config::Point2& to) {
  constexpr double kShortest = 1e-3;
  const double length = (point(to).vector() - point(from).vector()).norm();
  if (length < kShortest) throw text.error(key, "a length of 0 m", "two different points");
}

// What must fit into what: a letter that is longer paints outside the field.
void check_rulebook(const TextFile& text, const FieldFile& file) {
  const FieldFile::Rulebook& letters = file.rulebook();

  struct Limit {
    const char* key;
    double value;
    double most;
    const char* what;
  };

  const double half_length = 0.5 * file.length_m();
  const Limit limits[] = {
      {"goal_area_length_m", letters.goal_area_length_m(), half_length, "half the field's length"},
      {"goal_area_width_m", letters.goal_area_width_m(), file.width_m(), "the field's width"},
      {"penalty_area_length_m",
       letters.penalty_area_length_m(),
       half_length,
       "half the field's length"},
      {"penalty_area_width_m", letters.penalty_area_width_m(), file.width_m(), "the field's width"},
      {"centre_circle_radius_m",
       letters.centre_circle_radius_m(),
       0.5 * std::min(file.width_m(), file.length_m()),
       "half the field's width"},
      {"penalty_spot_distance_m",
       letters.penalty_spot_distance_m(),
       half_length,
       "half the field's length"},
      {"goal_width_m", letters.goal_width_m(), file.width_m(), "the field's width"},
  };
  for (const Limit& limit : limits) {
    if (limit.value <= limit.most) continue;
    throw text.error(std::string("rulebook.") + limit.key,
                     text_of(limit.value),
                     std::string("at most ") + limit.what + ", " + text_of(limit.most));
  }
}

void check_pair(const TextFile& text, const char* key, double length, double width) {
  if ((length > 0.0) == (width > 0.0)) return;
  throw text.error(key,
                   "length " + text_of(length) + " and width " + text_of(width),
                   "both above 0, or both 0 for an area that is not painted");
}

void check_field(const TextFile& text, const FieldFile& file, const FieldModel& field) {
  for (int i = 0; i < file.line_size(); ++i) {
    check_length(text, key_of("line", i), file.line(i).from(), file.line(i).to());
  }
  for (int i = 0; i < file.goal_size(); ++i) {
    check_length(text, key_of("goal", i), file.goal(i).left_post(), file.goal(i).right_post());
  }
  for (int i = 0; i < file.wall_size(); ++i) {
    check_length(text, key_of("wall", i), file.wall(i).from(), file.wall(i).to());
  }
  if (field.lines.empty() && field.arcs.empty()) {
    throw text.error("line", "neither lines nor arcs", "a rulebook block, a line or an arc");
  }
}

}  // namespace

FieldModel load_field(const std::filesystem::path& path) {
  FieldFile file;
  const TextFile text = TextFile::read(path, file);
  FieldModel field;
  field.name = file.name();
  field.length = file.length_m();
  field.width = file.width_m();
  field.surround = file.surround_m();
  field.line_width = file.line_width_m();
  if (file.has_rulebook()) {
    const FieldFile::Rulebook& letters = file.rulebook();
    check_rulebook(text, file);
    check_pair(text,
               "rulebook.goal_area_length_m",
               letters.goal_area_length_m(),
               letters.goal_area_width_m());
    check_pair(text,
               "rulebook.penalty_area_length_m",
               letters.penalty_area_length_m(),
               letters.penalty_area_width_m());
    add_rulebook(field, letters);
  }
  add_shapes(field, file);
  check_field(text, file, field);
  return shifted(std::move(field), point(file.offset()).vector());
}

}  // namespace teamsight::settings
