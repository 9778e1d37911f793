// vision/line_map.hpp: which paint is nearest, looked up instead of searched.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_model.hpp"
#include "geometry/frames.hpp"

namespace teamsight::vision {

/// A field with a grid over its carpet that knows the nearest line or arc of each cell.
///
/// The grid only names the primitive; residuals are exact distances to that primitive, so nothing
/// is rounded to cells. Lines of the field file along the foot of a wall or the side of a goal are
/// left out: there carpet ends at something white, which is no line with carpet on both sides, so
/// no line point ever lies there.
class LineMap {
 public:
  /// Makes the grid: some milliseconds.
  ///
  /// @pre the field has at least one line or arc
  explicit LineMap(const FieldModel& field);

  /// Exact signed distance to the primitive that is nearest to the cell of `p_F`.
  [[nodiscard]] NearestLine nearest(const Eigen::Vector2d& p_F) const;

  [[nodiscard]] const FieldModel& field() const { return field_; }

 private:
  /// A primitive as `nearest` needs it, in F: neither roots nor angles are left to be taken.
  struct Paint {
    std::array<Eigen::Vector2d, 2> ends;
    Eigen::Vector2d centre;       // of the arc
    Eigen::Vector2d along;        // unit length: of the segment, or from centre to the arc's middle
    double length{0.0};           // of the segment; radius of the arc; m
    double cos_half_sweep{-1.0};  // of the arc; less than -1: it has no end
    bool is_segment{true};
  };

  static constexpr double kCell = 0.05;  // m; half a line's width

  [[nodiscard]] static NearestLine nearest_on(const Paint& paint, const Eigen::Vector2d& p_F);
  /// Beyond the ends: away from the nearer one.
  [[nodiscard]] static NearestLine nearest_end(const std::array<Eigen::Vector2d, 2>& ends,
                                               const Eigen::Vector2d& p_F);
  [[nodiscard]] std::size_t cell_of(const Eigen::Vector2d& p_F) const;

  FieldModel field_;
  FieldModel painted_;  // of field_, what line points can lie on; primitives count in here
  std::vector<Paint> paint_;
  Eigen::Vector2d corner_F_;  // of the first cell
  int columns_{0};
  int rows_{0};
  std::vector<std::uint16_t> primitive_;
};

// By hand, and here: these run for every point in every step of a fit.

inline std::size_t LineMap::cell_of(const Eigen::Vector2d& p_F) const {
  constexpr double kCellsPerMetre = 1.0 / kCell;
  const double x = kCellsPerMetre * (p_F.x() - corner_F_.x());
  const double y = kCellsPerMetre * (p_F.y() - corner_F_.y());
  const auto column = static_cast<std::size_t>(std::max(0.0, std::min(x, columns_ - 1.0)));
  const auto row = static_cast<std::size_t>(std::max(0.0, std::min(y, rows_ - 1.0)));
  return row * static_cast<std::size_t>(columns_) + column;
}

inline NearestLine LineMap::nearest_on(const Paint& paint, const Eigen::Vector2d& p_F) {
  NearestLine result;
  if (paint.is_segment) {
    const Eigen::Vector2d offset = p_F - paint.ends[0];
    const double along = offset.dot(paint.along);
    if (along < 0.0 || along > paint.length) return nearest_end(paint.ends, p_F);
    result.normal_F = {-paint.along.y(), paint.along.x()};
    result.closest_F = paint.ends[0] + along * paint.along;
    result.distance = offset.dot(result.normal_F);
    return result;
  }
  const Eigen::Vector2d offset = p_F - paint.centre;
  const double range = offset.norm();
  if (offset.dot(paint.along) < range * paint.cos_half_sweep) {
    return nearest_end(paint.ends, p_F);
  }
  result.normal_F = range > 0.0 ? Eigen::Vector2d(offset / range) : paint.along;
  result.closest_F = paint.centre + paint.length * result.normal_F;
  result.distance = range - paint.length;
  return result;
}

inline NearestLine LineMap::nearest(const Eigen::Vector2d& p_F) const {
  const std::uint16_t primitive = primitive_[cell_of(p_F)];
  NearestLine result = nearest_on(paint_[primitive], p_F);
  result.primitive = primitive;
  return result;
}

}  // namespace teamsight::vision
