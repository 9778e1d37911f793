// sim/render/hall.hpp: what a camera sees beyond the carpet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_model.hpp"
#include "sim/render/paint.hpp"

namespace teamsight::sim {

/// Low boards around the carpet, a bare floor behind them, and the walls of a hall with doors,
/// windows, cupboards and spectators, drawn from a seed.
class Hall {
 public:
  Hall(const FieldModel& field, std::uint32_t seed);

  /// What a line of sight shows that leaves the carpet.
  ///
  /// @param origin_F, direction_F  m, unit length
  /// @param pixel_height           of the pixel, up and down; rad
  [[nodiscard]] Light look(const Eigen::Vector3f& origin_F,
                           const Eigen::Vector3f& direction_F,
                           float pixel_height) const;

 private:
  /// A box around the centre, and where a line of sight leaves it.
  struct Box {
    Eigen::Vector2f low;
    Eigen::Vector2f high;
  };

  struct Exit {
    float t{0.0F};      // along the direction; negative: it starts outside
    float along{0.0F};  // place on the wall, counted around the box from its corner; m
  };

  [[nodiscard]] static Exit leave(const Box& box,
                                  const Eigen::Vector3f& origin,
                                  const Eigen::Vector3f& direction);
  void furnish(std::uint32_t seed);
  void fill(double from, double to, double low, double high, const Paint& paint);

  [[nodiscard]] std::size_t index_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  [[nodiscard]] Light wall(float along, float z) const;
  [[nodiscard]] static Light ceiling(const Eigen::Vector3f& p_F);

  Box carpet_;
  Box hall_;
  int columns_{0};
  std::vector<Paint> walls_;  // by row (upwards) * columns_ + column (around)
};

}  // namespace teamsight::sim
