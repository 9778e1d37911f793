// bench/locate_rivals/distance_table.cpp: filling the table.
#include "bench/locate_rivals/distance_table.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::locate_rivals {

namespace {

constexpr double kMargin = 1.5;  // m around the carpet

}  // namespace

DistanceTable::DistanceTable(const FieldModel& field, double cell) : cell_(cell) {
  const Eigen::Vector2d half{0.5 * field.length + field.surround + kMargin,
                             0.5 * field.width + field.surround + kMargin};
  corner_F_ = field.centre.vector() - half;
  columns_ = static_cast<int>(std::ceil(2.0 * half.x() / cell));
  rows_ = static_cast<int>(std::ceil(2.0 * half.y() / cell));
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector2d middle = corner_F_ + cell * Eigen::Vector2d(column + 0.5, row + 0.5);
      const auto nearest = nearest_line(field, Point<Field>::from(middle));
      distance_.push_back(nearest ? static_cast<float>(std::abs(nearest->distance)) : 0.0F);
    }
  }
  gradient_.reserve(distance_.size());
  const auto step = static_cast<float>(8.0 * cell);  // the Sobel filter's weights, twice the step
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const float right =
          at(column + 1, row - 1) + 2.0F * at(column + 1, row) + at(column + 1, row + 1);
      const float left =
          at(column - 1, row - 1) + 2.0F * at(column - 1, row) + at(column - 1, row + 1);
      const float up =
          at(column - 1, row + 1) + 2.0F * at(column, row + 1) + at(column + 1, row + 1);
      const float down =
          at(column - 1, row - 1) + 2.0F * at(column, row - 1) + at(column + 1, row - 1);
      gradient_.emplace_back((right - left) / step, (up - down) / step);
    }
  }
}

float DistanceTable::at(int column, int row) const {
  const auto c = static_cast<std::size_t>(std::clamp(column, 0, columns_ - 1));
  const auto r = static_cast<std::size_t>(std::clamp(row, 0, rows_ - 1));
  return distance_[r * static_cast<std::size_t>(columns_) + c];
}

std::size_t DistanceTable::cell_of(const Eigen::Vector2d& p_F) const {
  const Eigen::Vector2d cell = (p_F - corner_F_) / cell_;
  const auto column = static_cast<std::size_t>(std::clamp(cell.x(), 0.0, columns_ - 1.0));
  const auto row = static_cast<std::size_t>(std::clamp(cell.y(), 0.0, rows_ - 1.0));
  return row * static_cast<std::size_t>(columns_) + column;
}

}  // namespace teamsight::locate_rivals
