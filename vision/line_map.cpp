// vision/line_map.cpp: the nearest-primitive grid.
#include "vision/line_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

constexpr double kMargin = 1.5;   // m around the carpet: points of a wrong candidate fall there
constexpr double kNoEnd = -2.0;   // less than any cosine
constexpr double kOnFoot = 0.02;  // m, of a line's end from the foot that it marks

/// Where something upright stands on the floor; m in F.
struct Foot {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

bool stands_on(const Eigen::Vector2d& p_F, const Foot& foot) {
  const Eigen::Vector2d way = foot.to - foot.from;
  const double share = (p_F - foot.from).dot(way) / std::max(way.squaredNorm(), 1e-12);
  return (foot.from + std::clamp(share, 0.0, 1.0) * way - p_F).norm() < kOnFoot;
}

Eigen::Vector2d unit_at(double direction) {
  return {std::cos(direction), std::sin(direction)};
}

// The feet of walls and of the sides of goals.
std::vector<Foot> feet_of(const FieldModel& field) {
  std::vector<Foot> feet;
  for (const Wall& wall : field.walls) feet.push_back({wall.from.vector(), wall.to.vector()});
  for (const Goal& goal : field.goals) {
    const Eigen::Vector2d left = goal.left_post.vector();
    const Eigen::Vector2d right = goal.right_post.vector();
    const Eigen::Vector2d across = (left - right).normalized();
    // Seen from the field, what is behind the mouth lies a quarter turn clockwise from its left.
    const Eigen::Vector2d back = goal.depth * Eigen::Vector2d(across.y(), -across.x());
    feet.push_back({left, left + back});
    feet.push_back({right, right + back});
  }
  return feet;
}

// The field without the lines that only mark such feet, unless nothing else would be left.
FieldModel painted_part(const FieldModel& field) {
  const std::vector<Foot> feet = feet_of(field);
  FieldModel painted = field;
  std::erase_if(painted.lines, [&](const FieldLine& line) {
    return std::ranges::any_of(feet, [&](const Foot& foot) {
      return stands_on(line.from.vector(), foot) && stands_on(line.to.vector(), foot);
    });
  });
  return painted.lines.empty() && painted.arcs.empty() ? field : painted;
}

}  // namespace

LineMap::LineMap(const FieldModel& field) : field_(field), painted_(painted_part(field)) {
  TEAMSIGHT_EXPECT(!field.lines.empty() || !field.arcs.empty());
  const Eigen::Vector2d half{0.5 * field.length + field.surround + kMargin,
                             0.5 * field.width + field.surround + kMargin};
  for (const FieldLine& line : painted_.lines) {
    const Eigen::Vector2d along = line.to.vector() - line.from.vector();
    paint_.push_back({{line.from.vector(), line.to.vector()},
                      Eigen::Vector2d::Zero(),
                      along.normalized(),
                      along.norm(),
                      0.0,
                      true});
  }
  for (const FieldArc& arc : painted_.arcs) {
    const Eigen::Vector2d centre = arc.centre.vector();
    const bool is_circle = arc.sweep >= 2.0 * std::numbers::pi - 1e-9;
    paint_.push_back({{centre + arc.radius * unit_at(arc.start),
                       centre + arc.radius * unit_at(arc.start + arc.sweep)},
                      centre,
                      unit_at(arc.start + 0.5 * arc.sweep),
                      arc.radius,
                      is_circle ? kNoEnd : std::cos(0.5 * arc.sweep),
                      false});
  }
  corner_F_ = field.centre.vector() - half;
  columns_ = static_cast<int>(std::ceil(2.0 * half.x() / kCell));
  rows_ = static_cast<int>(std::ceil(2.0 * half.y() / kCell));
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  primitive_.reserve(cells);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector2d middle = corner_F_ + kCell * Eigen::Vector2d(column + 0.5, row + 0.5);
      const auto nearest = nearest_line(painted_, Point<Field>::from(middle));
      primitive_.push_back(nearest ? nearest->primitive : std::uint16_t{0});
    }
  }
}

NearestLine LineMap::nearest_end(const std::array<Eigen::Vector2d, 2>& ends,
                                 const Eigen::Vector2d& p_F) {
  const bool is_first = (p_F - ends[0]).squaredNorm() <= (p_F - ends[1]).squaredNorm();
  NearestLine result;
  result.closest_F = ends.at(is_first ? 0 : 1);
  result.is_end = true;
  const Eigen::Vector2d offset = p_F - result.closest_F;
  result.distance = offset.norm();
  result.normal_F =
      result.distance > 0.0 ? Eigen::Vector2d(offset / result.distance) : Eigen::Vector2d::UnitX();
  return result;
}

}  // namespace teamsight::vision
