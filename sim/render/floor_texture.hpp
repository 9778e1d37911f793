// sim/render/floor_texture.hpp: the painted floor as a picture, made once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
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

  /// Places in a straight line, one step from each to the next, in F; m.
  struct Row {
    float x{0.0F};  ///< of the first place
    float y{0.0F};
    float step_x{0.0F};
    float step_y{0.0F};
    int count{1};
  };

  /// The light of a row of places, as if each were looked up with `at`.
  struct Sum {
    float brightness{0.0F};  ///< of the places together
    float painted{0.0F};     ///< of brightness times paint
    int on_carpet{0};        ///< how many of them
  };

  /// @param row    of at least one place
  /// @param level  0 ... kLevels - 1
  [[nodiscard]] Sum sum_of(const Row& row, int level) const;

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
  static constexpr float kPerPaint = 1.0F / (256.0F * kPaint);
  static constexpr float kPerBrightness = 1.0F / (256.0F * kNominal);
  static constexpr float kOne = 65536.0F;  // a square, as a number of blended()

  /// What lies between four squares, 256 times as fine as in a Texel.
  struct Blend {
    std::uint32_t paint{0};
    std::uint32_t brightness{0};
  };

  struct Level {
    int columns{0};
    int rows{0};
    float per_metre{0.0F};
    float last_column{0.0F};  // up to where there is a neighbour to the right
    float last_row{0.0F};
    std::vector<Texel> texels;
  };

  [[nodiscard]] static Blend blended(const Level& grid, std::int32_t across, std::int32_t down);
  [[nodiscard]] static std::optional<Sum> sum_inside(const Level& grid, const Row& row);
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

// Here, because it is called for every pixel. Weights have four bits, so that two squares fit side
// by side into one number.
inline FloorTexture::Spot FloorTexture::at(float x, float y, int level) const {
  if (!is_carpet(x, y)) {
    return {};
  }
  const Level& grid = levels_[static_cast<std::size_t>(level)];
  const float column = std::clamp((x - min_x_) * grid.per_metre - 0.5F, 0.0F, grid.last_column);
  const float row = std::clamp((y - min_y_) * grid.per_metre - 0.5F, 0.0F, grid.last_row);
  const Blend blend = blended(
      grid, static_cast<std::int32_t>(kOne * column), static_cast<std::int32_t>(kOne * row));
  return {static_cast<float>(blend.paint) * kPerPaint,
          static_cast<float>(blend.brightness) * kPerBrightness};
}

inline FloorTexture::Blend FloorTexture::blended(const Level& grid,
                                                 std::int32_t across,
                                                 std::int32_t down) {
  const std::uint32_t fx = static_cast<std::uint32_t>(across) >> 12U & 15U;
  const std::uint32_t fy = static_cast<std::uint32_t>(down) >> 12U & 15U;
  const Texel* upper =
      grid.texels.data() + std::ptrdiff_t{down >> 16} * grid.columns + (across >> 16);
  const Texel* lower = upper + grid.columns;
  // Four neighbouring bytes: the compiler makes one read of them.
  const auto both = [](const Texel* left) {
    return std::uint32_t{left[0].paint} | std::uint32_t{left[0].brightness} << 8U |
           std::uint32_t{left[1].paint} << 16U | std::uint32_t{left[1].brightness} << 24U;
  };
  const auto mixed = [fx, fy](std::uint32_t first, std::uint32_t second) {
    const std::uint32_t sides = first * (16U - fy) + second * fy;
    return (sides & 0xFFFFU) * (16U - fx) + (sides >> 16U) * fx;
  };
  const std::uint32_t above = both(upper);
  const std::uint32_t below = both(lower);
  constexpr std::uint32_t kEven = 0x00FF00FFU;
  return {mixed(above & kEven, below & kEven), mixed(above >> 8U & kEven, below >> 8U & kEven)};
}

}  // namespace teamsight::sim
