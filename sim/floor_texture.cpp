// sim/floor_texture.cpp: see floor_texture.hpp.
#include "sim/floor_texture.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

FloorTexture::FloorTexture(const FieldModel& field)
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
  finest.paint.resize(static_cast<std::size_t>(finest.columns) *
                      static_cast<std::size_t>(finest.rows));
  levels_.push_back(std::move(finest));
  paint(field);
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
          finest.paint[static_cast<std::size_t>(row) * static_cast<std::size_t>(finest.columns) +
                       static_cast<std::size_t>(column)];
      square = std::max(square, static_cast<std::uint8_t>(std::lround(kPaint * share)));
    }
  }
}

void FloorTexture::add_coarser_levels() {
  while (levels_.size() < static_cast<std::size_t>(kLevels)) {
    levels_.push_back(halved(levels_.back()));
  }
}

// Each square holds the mean of four.
FloorTexture::Level FloorTexture::halved(const Level& fine) {
  Level coarse{fine.columns / 2, fine.rows / 2, fine.per_metre / 2.0F, {}};
  const auto columns = static_cast<std::size_t>(fine.columns);
  for (std::size_t row = 0; row < static_cast<std::size_t>(coarse.rows); ++row) {
    for (std::size_t column = 0; column < static_cast<std::size_t>(coarse.columns); ++column) {
      const std::size_t above = 2 * row * columns + 2 * column;
      const std::size_t below = above + columns;
      const int sum =
          fine.paint[above] + fine.paint[above + 1] + fine.paint[below] + fine.paint[below + 1];
      coarse.paint.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
    }
  }
  return coarse;
}

std::uint8_t FloorTexture::at(float x, float y, int level) const {
  if (x < min_x_ || y < min_y_ || x >= max_x_ || y >= max_y_) {
    return kBeyond;
  }
  const Level& grid = levels_[static_cast<std::size_t>(level)];
  const float column = std::clamp(
      (x - min_x_) * grid.per_metre - 0.5F, 0.0F, static_cast<float>(grid.columns) - 1.001F);
  const float row = std::clamp(
      (y - min_y_) * grid.per_metre - 0.5F, 0.0F, static_cast<float>(grid.rows) - 1.001F);
  const int c = static_cast<int>(column);
  const int r = static_cast<int>(row);
  const int fx = static_cast<int>(256.0F * (column - static_cast<float>(c)));
  const int fy = static_cast<int>(256.0F * (row - static_cast<float>(r)));
  const std::uint8_t* corner =
      grid.paint.data() + static_cast<std::ptrdiff_t>(r) * grid.columns + c;
  const int upper = corner[0] * (256 - fx) + corner[1] * fx;
  const int lower = corner[grid.columns] * (256 - fx) + corner[grid.columns + 1] * fx;
  return static_cast<std::uint8_t>((upper * (256 - fy) + lower * fy + 32768) >> 16);
}

}  // namespace teamsight::sim
