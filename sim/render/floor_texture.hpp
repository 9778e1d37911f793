// sim/render/floor_texture.hpp: the painted floor as a picture, made once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/field_model.hpp"

namespace teamsight::sim {

/// How much of each small square of the floor is painted and how bright it lies there, at several
/// sizes of square: level 0 has squares of 1 cm, each level's are twice as wide and hold the mean
/// of four. Brightness is that of lamps, wear and the carpet's grain; it depends on the seed only.
class FloorTexture {
 public:
  static constexpr double kFinest = 0.01;  ///< width of a square at level 0; m
  static constexpr int kLevels = 7;

  /// @param unevenness  how much brightness varies, as a share of it; 0: not at all
  FloorTexture(const FieldModel& field, double unevenness, std::uint32_t seed);

  struct Spot {
    float paint{0.0F};       ///< share, 0 to 1
    float brightness{0.0F};  ///< 1 is nominal; 0 where the carpet ends
  };

  /// What lies around a place, between the middles of the squares.
  ///
  /// @param level 0 ... kLevels - 1
  [[nodiscard]] Spot at(float x, float y, int level) const;

  /// Whether there is carpet.
  [[nodiscard]] bool is_carpet(float x, float y) const {
    return x >= min_x_ && y >= min_y_ && x < max_x_ && y < max_y_;
  }

 private:
  struct Texel {
    std::uint8_t paint{0};
    std::uint8_t brightness{kNominal};
  };

  static constexpr std::uint8_t kPaint = 240;    // all paint
  static constexpr std::uint8_t kNominal = 160;  // brightness 1

  struct Level {
    int columns{0};
    int rows{0};
    float per_metre{0.0F};
    float last_column{0.0F};  // up to where there is a neighbour to the right
    float last_row{0.0F};
    std::vector<Texel> texels;
  };

  void paint(const FieldModel& field);
  template <class Distance>
  void paint_patch(const Eigen::Vector2d& low,
                   const Eigen::Vector2d& high,
                   double half_width,
                   Distance distance);
  void brighten(double unevenness, std::uint32_t seed);
  void add_coarser_levels();
  [[nodiscard]] static Level halved(const Level& fine);

  float min_x_;
  float min_y_;
  float max_x_;
  float max_y_;
  std::vector<Level> levels_;
};

// Here, because it is called for every pixel. Weights have four bits, so that paint and brightness
// fit side by side into one number.
inline FloorTexture::Spot FloorTexture::at(float x, float y, int level) const {
  if (!is_carpet(x, y)) {
    return {};
  }
  const Level& grid = levels_[static_cast<std::size_t>(level)];
  const float column = std::clamp((x - min_x_) * grid.per_metre - 0.5F, 0.0F, grid.last_column);
  const float row = std::clamp((y - min_y_) * grid.per_metre - 0.5F, 0.0F, grid.last_row);
  const auto across = static_cast<std::uint32_t>(16.0F * column);
  const auto down = static_cast<std::uint32_t>(16.0F * row);
  const std::uint32_t fx = across & 15U;
  const std::uint32_t fy = down & 15U;
  const Texel* upper =
      grid.texels.data() +
      static_cast<std::size_t>(down >> 4U) * static_cast<std::size_t>(grid.columns) +
      (across >> 4U);
  const Texel* lower = upper + grid.columns;
  const auto both = [](const Texel& texel) {
    return std::uint32_t{texel.paint} | std::uint32_t{texel.brightness} << 16U;
  };
  const std::uint32_t sum = both(upper[0]) * ((16U - fx) * (16U - fy)) +
                            both(upper[1]) * (fx * (16U - fy)) +
                            both(lower[0]) * ((16U - fx) * fy) + both(lower[1]) * (fx * fy);
  return {static_cast<float>(sum & 0xFFFFU) * (1.0F / (256.0F * kPaint)),
          static_cast<float>(sum >> 16U) * (1.0F / (256.0F * kNominal))};
}

}  // namespace teamsight::sim
