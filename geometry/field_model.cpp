// geometry/field_model.cpp: nearest paint, symmetry and shifting of a field.
#include "geometry/field_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"
#include "geometry/expect.hpp"

namespace teamsight {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

NearestLine away_from(const Eigen::Vector2d& closest, const Eigen::Vector2d& p, bool is_end) {
  NearestLine result;
  result.closest_F = closest;
  result.is_end = is_end;
  const Eigen::Vector2d offset = p - closest;
  result.distance = offset.norm();
  result.normal_F =
      result.distance > 0.0 ? Eigen::Vector2d(offset / result.distance) : Eigen::Vector2d::UnitX();
  return result;
}

NearestLine nearest_on(const FieldLine& line, const Eigen::Vector2d& p) {
  const Eigen::Vector2d a = line.from.vector();
  const Eigen::Vector2d along = line.to.vector() - a;
  const double length = along.norm();
  const Eigen::Vector2d unit = along / length;
  const double t = (p - a).dot(unit);
  if (t < 0.0) return away_from(a, p, true);
  if (t > length) return away_from(line.to.vector(), p, true);
  NearestLine result;
  result.closest_F = a + t * unit;
  result.normal_F = {-unit.y(), unit.x()};
  result.distance = (p - a).dot(result.normal_F);
  return result;
}

Eigen::Vector2d point_of(const FieldArc& arc, double direction) {
  return arc.centre.vector() +
         arc.radius * Eigen::Vector2d(std::cos(direction), std::sin(direction));
}

NearestLine nearest_on(const FieldArc& arc, const Eigen::Vector2d& p) {
  const Eigen::Vector2d offset = p - arc.centre.vector();
  const double range = offset.norm();
  const double direction = range > 0.0 ? std::atan2(offset.y(), offset.x()) : arc.start;
  double along = std::fmod(direction - arc.start, kTurn);
  if (along < 0.0) along += kTurn;
  if (along <= arc.sweep) {
    NearestLine result;
    result.normal_F = {std::cos(direction), std::sin(direction)};
    result.closest_F = point_of(arc, direction);
    result.distance = range - arc.radius;
    return result;
  }
  const double past_end = along - arc.sweep;
  const double before_start = kTurn - along;
  return away_from(
      point_of(arc, past_end < before_start ? arc.start + arc.sweep : arc.start), p, true);
}

}  // namespace

NearestLine line_at(const FieldModel& field, std::uint16_t primitive, const Point<Field>& p_F) {
  TEAMSIGHT_EXPECT(primitive < field.lines.size() + field.arcs.size());
  NearestLine result = primitive < field.lines.size()
                           ? nearest_on(field.lines[primitive], p_F.vector())
                           : nearest_on(field.arcs[primitive - field.lines.size()], p_F.vector());
  result.primitive = primitive;
  return result;
}

std::optional<NearestLine> nearest_line(const FieldModel& field, const Point<Field>& p_F) {
  std::optional<NearestLine> best;
  const auto count = static_cast<std::uint16_t>(field.lines.size() + field.arcs.size());
  for (std::uint16_t i = 0; i < count; ++i) {
    const NearestLine candidate = line_at(field, i, p_F);
    if (!best || std::abs(candidate.distance) < std::abs(best->distance)) best = candidate;
  }
  return best;
}

bool is_on_carpet(const FieldModel& field, const Point<Field>& p_F) {
  const Eigen::Vector2d from_centre = p_F.vector() - field.centre.vector();
  return std::abs(from_centre.x()) <= 0.5 * field.length + field.surround &&
         std::abs(from_centre.y()) <= 0.5 * field.width + field.surround;
}

bool is_half_turn_symmetric(const FieldModel& field) {
  constexpr double kSame = 1e-6;
  const auto turned = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return 2.0 * field.centre.vector() - p;
  };
  const bool lines_match = std::ranges::all_of(field.lines, [&](const FieldLine& line) {
    return std::ranges::any_of(field.lines, [&](const FieldLine& other) {
      const double straight = (turned(line.from.vector()) - other.from.vector()).norm() +
                              (turned(line.to.vector()) - other.to.vector()).norm();
      const double crossed = (turned(line.from.vector()) - other.to.vector()).norm() +
                             (turned(line.to.vector()) - other.from.vector()).norm();
      return std::min(straight, crossed) < kSame;
    });
  });
  const bool arcs_match = std::ranges::all_of(field.arcs, [&](const FieldArc& arc) {
    return std::ranges::any_of(field.arcs, [&](const FieldArc& other) {
      const bool whole = arc.sweep >= kTurn - kSame && other.sweep >= kTurn - kSame;
      const double start_gap = wrap_angle(arc.start + std::numbers::pi - other.start);
      return (turned(arc.centre.vector()) - other.centre.vector()).norm() < kSame &&
             std::abs(arc.radius - other.radius) < kSame &&
             (whole || (std::abs(start_gap) < kSame && std::abs(arc.sweep - other.sweep) < kSame));
    });
  });
  return lines_match && arcs_match;
}

FieldModel shifted(FieldModel field, const Eigen::Vector2d& offset_F) {
  const auto move = [&](Point<Field>& p) {
    p = Point<Field>::from(p.vector() + offset_F);
  };
  move(field.centre);
  for (FieldLine& line : field.lines) {
    move(line.from);
    move(line.to);
  }
  for (FieldArc& arc : field.arcs) move(arc.centre);
  for (FieldSpot& spot : field.spots) move(spot.centre);
  for (Goal& goal : field.goals) {
    move(goal.left_post);
    move(goal.right_post);
  }
  for (Wall& wall : field.walls) {
    move(wall.from);
    move(wall.to);
  }
  return field;
}

}  // namespace teamsight
