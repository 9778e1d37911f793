// bench/locate_rivals/distance_table.hpp: distance to the nearest paint, rounded to cells.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_model.hpp"

namespace teamsight::locate_rivals {

/// The table that the classical methods look distances up in: one number per cell of 50 mm, and the
/// gradient of that by a Sobel filter, as Tribots, CAMBADA and NuBot have it.
class DistanceTable {
 public:
  explicit DistanceTable(const FieldModel& field, double cell = 0.05);

  /// At the nearest cell; m.
  [[nodiscard]] double distance(const Eigen::Vector2d& p_F) const {
    return static_cast<double>(distance_[cell_of(p_F)]);
  }

  /// Of the distance at the nearest cell; dimensionless.
  [[nodiscard]] Eigen::Vector2d gradient(const Eigen::Vector2d& p_F) const {
    return gradient_[cell_of(p_F)].cast<double>();
  }

 private:
  [[nodiscard]] std::size_t cell_of(const Eigen::Vector2d& p_F) const;
  [[nodiscard]] float at(int column, int row) const;

  double cell_;
  Eigen::Vector2d corner_F_;
  int columns_{0};
  int rows_{0};
  std::vector<float> distance_;
  std::vector<Eigen::Vector2f> gradient_;
};

}  // namespace teamsight::locate_rivals
