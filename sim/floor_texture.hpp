// sim/floor_texture.hpp: the painted floor as a picture, made once.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/field_model.hpp"

namespace teamsight::sim {

/// How much of each small square of the floor is painted, at several sizes of square.
///
/// Level 0 has squares of 2 cm; each level's are twice as wide and hold the mean of four.
class FloorTexture {
 public:
  static constexpr double kFinest = 0.02;  ///< width of a square at level 0; m
  static constexpr int kLevels = 5;

  explicit FloorTexture(const FieldModel& field);

  /// Share of paint around a place, between the middles of the squares.
  ///
  /// @param level 0 ... kLevels - 1
  /// @return 0 (carpet) to 200 (paint); kBeyond where the carpet ends
  [[nodiscard]] std::uint8_t at(float x, float y, int level) const;

  static constexpr std::uint8_t kPaint = 200;
  static constexpr std::uint8_t kBeyond = 201;

 private:
  struct Level {
    int columns{0};
    int rows{0};
    float per_metre{0.0F};
    std::vector<std::uint8_t> paint;
  };

  void paint(const FieldModel& field);
  template <class Distance>
  void paint_patch(const Eigen::Vector2d& low,
                   const Eigen::Vector2d& high,
                   double half_width,
                   Distance distance);
  void add_coarser_levels();
  [[nodiscard]] static Level halved(const Level& fine);

  float min_x_;
  float min_y_;
  float max_x_;
  float max_y_;
  std::vector<Level> levels_;
};

}  // namespace teamsight::sim
