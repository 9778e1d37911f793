// vision/line_map.cpp: the nearest-primitive grid.
#include "vision/line_map.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

constexpr double kCell = 0.05;   // m; half a line's width
constexpr double kMargin = 1.5;  // m around the carpet: points of a wrong candidate fall there

}  // namespace

LineMap::LineMap(const FieldModel& field) : field_(field) {
  TEAMSIGHT_EXPECT(!field.lines.empty() || !field.arcs.empty());
  const Eigen::Vector2d half{0.5 * field.length + field.surround + kMargin,
                             0.5 * field.width + field.surround + kMargin};
  corner_F_ = field.centre.vector() - half;
  columns_ = static_cast<int>(std::ceil(2.0 * half.x() / kCell));
  rows_ = static_cast<int>(std::ceil(2.0 * half.y() / kCell));
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  primitive_.reserve(cells);
  distance_.reserve(cells);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector2d middle = corner_F_ + kCell * Eigen::Vector2d(column + 0.5, row + 0.5);
      const auto nearest = nearest_line(field_, Point<Field>::from(middle));
      primitive_.push_back(nearest ? nearest->primitive : std::uint16_t{0});
      distance_.push_back(nearest ? static_cast<float>(std::abs(nearest->distance)) : 0.0F);
    }
  }
}

std::size_t LineMap::cell_of(const Eigen::Vector2d& p_F) const {
  const Eigen::Vector2d cell = (p_F - corner_F_) / kCell;
  const auto column = static_cast<std::size_t>(std::clamp(cell.x(), 0.0, columns_ - 1.0));
  const auto row = static_cast<std::size_t>(std::clamp(cell.y(), 0.0, rows_ - 1.0));
  return row * static_cast<std::size_t>(columns_) + column;
}

NearestLine LineMap::nearest(const Eigen::Vector2d& p_F) const {
  return line_at(field_, primitive_[cell_of(p_F)], Point<Field>::from(p_F));
}

}  // namespace teamsight::vision
