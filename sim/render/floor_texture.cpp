// sim/render/floor_texture.cpp: see floor_texture.hpp.
#include "sim/render/floor_texture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/match/random.hpp"

namespace teamsight::sim {
namespace {

// Share of a square whose middle is `distance` from the middle of a band that is painted. The
// band's edge is taken as straight and square to the way there: exact along the axes.
double share_of_band(double distance, double half_width, double square) {
  return std::clamp((half_width - distance) / square + 0.5, 0.0, 1.0);
}

// A rectangle of floor around one painted thing.
struct Patch {
  Eigen::Vector2d low;
  Eigen::Vector2d high;
};

Patch patch_of(const FieldModel& field, std::size_t primitive) {
  if (primitive < field.lines.size()) {
    const FieldLine& line = field.lines[primitive];
    return {line.from.vector().cwiseMin(line.to.vector()),
            line.from.vector().cwiseMax(line.to.vector())};
  }
  const FieldArc& arc = field.arcs[primitive - field.lines.size()];
  const Eigen::Vector2d radius(arc.radius, arc.radius);
  return {arc.centre.vector() - radius, arc.centre.vector() + radius};
}

int squares(double length, double square) {
  return static_cast<int>(std::ceil(length / square));
}

// Noise between the corners of a grid of cells, in [-1, 1].
class Blotches {
 public:
  Blotches(double cell, Random& random) : cell_(cell) {
    for (float& value : values_) {
      value = static_cast<float>(random.uniform(-1.0, 1.0));
    }
  }

  [[nodiscard]] float at(double x, double y) const {
    const double column = std::floor(x / cell_);
    const double row = std::floor(y / cell_);
    const auto fx = static_cast<float>(x / cell_ - column);
    const auto fy = static_cast<float>(y / cell_ - row);
    const int c = static_cast<int>(column);
    const int r = static_cast<int>(row);
    const float upper = corner(c, r) + fx * (corner(c + 1, r) - corner(c, r));
    const float lower = corner(c, r + 1) + fx * (corner(c + 1, r + 1) - corner(c, r + 1));
    return upper + fy * (lower - upper);
  }

 private:
  static constexpr std::size_t kSide = 128;  // a power of two

  static std::size_t wrapped(int place) { return static_cast<std::size_t>(place) & (kSide - 1); }

  [[nodiscard]] float corner(int column, int row) const {
    return values_[wrapped(column) + kSide * wrapped(row)];
  }

  double cell_;
  std::array<float, kSide * kSide> values_{};
};

}  // namespace

FloorTexture::FloorTexture(const FieldModel& field, double unevenness, std::uint32_t seed)
    : min_x_(static_cast<float>(field.centre.x - field.length / 2.0 - field.surround)),
      min_y_(static_cast<float>(field.centre.y - field.width / 2.0 - field.surround)),
      max_x_(static_cast<float>(field.centre.x + field.length / 2.0 + field.surround)),
      max_y_(static_cast<float>(field.centre.y + field.width / 2.0 + field.surround)) {
  // The finest level's sides are whole multiples of the coarsest squares.
  const int block = 1 << (kLevels - 1);
  const double coarsest = kFinest * block;
  Level finest;
  finest.columns = block * squares(static_cast<double>(max_x_ - min_x_), coarsest);
  finest.rows = block * squares(static_cast<double>(max_y_ - min_y_), coarsest);
  finest.per_metre = static_cast<float>(1.0 / kFinest);
  finest.texels.resize(static_cast<std::size_t>(finest.columns) *
                       static_cast<std::size_t>(finest.rows));
  levels_.push_back(std::move(finest));
  paint(field);
  brighten(unevenness, seed);
  add_coarser_levels();
}

// Each primitive touches only the squares around it: looking at all for each square takes seconds.
void FloorTexture::paint(const FieldModel& field) {
  const std::size_t primitives = field.lines.size() + field.arcs.size();
  const double half_width = field.line_width / 2.0;
  for (std::size_t i = 0; i < primitives; ++i) {
    const Patch patch = patch_of(field, i);
    paint_patch(patch.low, patch.high, half_width, [&](const Point<Field>& p_F) {
      return std::abs(line_at(field, static_cast<std::uint16_t>(i), p_F).distance);
    });
  }
  for (const FieldSpot& spot : field.spots) {
    const Eigen::Vector2d centre = spot.centre.vector();
    paint_patch(centre, centre, spot.radius, [&](const Point<Field>& p_F) {
      return (p_F.vector() - centre).norm();
    });
  }
}

template <class Distance>
void FloorTexture::paint_patch(const Eigen::Vector2d& low,
                               const Eigen::Vector2d& high,
                               double half_width,
                               Distance distance) {
  Level& finest = levels_.front();
  const double border = half_width + kFinest;
  const auto index = [](double metres, float from, int count) {
    const double square = std::floor((metres - static_cast<double>(from)) / kFinest);
    return static_cast<int>(std::clamp(square, 0.0, count - 1.0));
  };
  const int last_row = index(high.y() + border, min_y_, finest.rows);
  const int last_column = index(high.x() + border, min_x_, finest.columns);
  for (int row = index(low.y() - border, min_y_, finest.rows); row <= last_row; ++row) {
    for (int column = index(low.x() - border, min_x_, finest.columns); column <= last_column;
         ++column) {
      const Point<Field> p_F{static_cast<double>(min_x_) + (column + 0.5) * kFinest,
                             static_cast<double>(min_y_) + (row + 0.5) * kFinest};
      const double share = share_of_band(distance(p_F), half_width, kFinest);
      std::uint8_t& square =
          finest
              .texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(finest.columns) +
                      static_cast<std::size_t>(column)]
              .paint;
      square = std::max(square, static_cast<std::uint8_t>(std::lround(kPaint * share)));
    }
  }
}

// Grain, tread and lamps; a seam every two metres of carpet.
void FloorTexture::brighten(double unevenness, std::uint32_t seed) {
  if (unevenness <= 0.0) {
    return;
  }
  Random random(seed);
  const Blotches grain(0.02, random);
  const Blotches tread(0.4, random);
  const Blotches lamps(4.0, random);
  Level& finest = levels_.front();
  std::size_t i = 0;
  for (int row = 0; row < finest.rows; ++row) {
    const double y = (row + 0.5) * kFinest;
    const bool is_seam = std::fmod(y, 2.0) < kFinest;
    for (int column = 0; column < finest.columns; ++column, ++i) {
      const double x = (column + 0.5) * kFinest;
      const float variation = 0.35F * grain.at(x, y) + 0.3F * tread.at(x, y) +
                              0.6F * lamps.at(x, y) - (is_seam ? 0.6F : 0.0F);
      const float brightness = 1.0F + static_cast<float>(unevenness) * variation;
      finest.texels[i].brightness =
          static_cast<std::uint8_t>(std::clamp(kNominal * brightness, 1.0F, 255.0F));
    }
  }
}

void FloorTexture::add_coarser_levels() {
  while (levels_.size() < static_cast<std::size_t>(kLevels)) {
    levels_.push_back(halved(levels_.back()));
  }
  for (Level& level : levels_) {
    level.last_column = static_cast<float>(level.columns) - 1.07F;
    level.last_row = static_cast<float>(level.rows) - 1.07F;
  }
}

FloorTexture::Sum FloorTexture::sum_of(const Row& row, int level) const {
  const Level& grid = levels_[static_cast<std::size_t>(level)];
  if (const std::optional<Sum> inside = sum_inside(grid,
                                                   {(row.x - min_x_) * grid.per_metre - 0.5F,
                                                    (row.y - min_y_) * grid.per_metre - 0.5F,
                                                    row.step_x * grid.per_metre,
                                                    row.step_y * grid.per_metre,
                                                    row.count})) {
    return *inside;
  }
  Sum sum;
  for (int i = 0; i < row.count; ++i) {
    const auto steps = static_cast<float>(i);
    const Spot spot = at(row.x + steps * row.step_x, row.y + steps * row.step_y, level);
    sum.on_carpet += spot.brightness > 0.0F ? 1 : 0;
    sum.brightness += spot.brightness;
    sum.painted += spot.brightness * spot.paint;
  }
  return sum;
}

// A row in squares, all of whose places have neighbours to the right and below; nothing otherwise.
// It goes on in 1/65536 of a square, so that there is no float in the loop.
std::optional<FloorTexture::Sum> FloorTexture::sum_inside(const Level& grid, const Row& row) {
  const auto steps = static_cast<float>(row.count - 1);
  const float last_x = row.x + steps * row.step_x;
  const float last_y = row.y + steps * row.step_y;
  if (!(std::min(row.x, last_x) >= 0.01F && std::max(row.x, last_x) <= grid.last_column &&
        std::min(row.y, last_y) >= 0.01F && std::max(row.y, last_y) <= grid.last_row)) {
    return std::nullopt;
  }
  auto across = static_cast<std::int32_t>(kOne * row.x);
  auto down = static_cast<std::int32_t>(kOne * row.y);
  const auto step_across = static_cast<std::int32_t>(kOne * row.step_x);
  const auto step_down = static_cast<std::int32_t>(kOne * row.step_y);
  std::uint32_t brightness = 0;
  std::uint64_t painted = 0;
  for (int i = 0; i < row.count; ++i, across += step_across, down += step_down) {
    const Blend blend = blended(grid, across, down);
    brightness += blend.brightness;
    painted += std::uint64_t{blend.brightness} * blend.paint;
  }
  return Sum{static_cast<float>(brightness) * kPerBrightness,
             static_cast<float>(painted) * (kPerBrightness * kPerPaint),
             row.count};
}

// Each square holds the mean of four.
FloorTexture::Level FloorTexture::halved(const Level& fine) {
  Level coarse;
  coarse.columns = fine.columns / 2;
  coarse.rows = fine.rows / 2;
  coarse.per_metre = fine.per_metre / 2.0F;
  const auto columns = static_cast<std::size_t>(fine.columns);
  for (std::size_t row = 0; row < static_cast<std::size_t>(coarse.rows); ++row) {
    for (std::size_t column = 0; column < static_cast<std::size_t>(coarse.columns); ++column) {
      const Texel* above = fine.texels.data() + 2 * row * columns + 2 * column;
      const Texel* below = above + columns;
      const int paint = above[0].paint + above[1].paint + below[0].paint + below[1].paint;
      const int brightness =
          above[0].brightness + above[1].brightness + below[0].brightness + below[1].brightness;
      coarse.texels.push_back({static_cast<std::uint8_t>((paint + 2) / 4),
                               static_cast<std::uint8_t>((brightness + 2) / 4)});
    }
  }
  return coarse;
}

}  // namespace teamsight::sim
