// sim/render/meridian.cpp: see meridian.hpp.
#include "sim/render/meridian.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "geometry/expect.hpp"

namespace teamsight::sim {
namespace {

constexpr double kKink = 1e-7;        // m
constexpr std::size_t kParts = 4096;  // of the width

// Whether the curve is smooth from point i to i + 1.
bool is_smooth(const std::vector<vision::ProfilePoint>& points, std::size_t i) {
  return points[i + 1].x - points[i].x > kKink;
}

struct Stretch {
  std::size_t first{0};
  std::size_t last{0};
};

// Two points on each side of the piece from point i where there are, four in all where the smooth
// stretch is that long.
Stretch neighbours_of(const std::vector<vision::ProfilePoint>& points, std::size_t i) {
  Stretch stretch{i, i + 1};
  while (stretch.last - stretch.first < 3) {
    const bool back = stretch.first > 0 && is_smooth(points, stretch.first - 1);
    const bool on = stretch.last + 1 < points.size() && is_smooth(points, stretch.last);
    const bool back_is_short = i - stretch.first <= stretch.last - i - 1;
    if (back && (back_is_short || !on)) {
      --stretch.first;
    } else if (on) {
      ++stretch.last;
    } else {
      break;
    }
  }
  return stretch;
}

}  // namespace

Meridian::Meridian(const std::vector<vision::ProfilePoint>& points) {
  TEAMSIGHT_EXPECT(points.size() >= 2);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (is_smooth(points, i)) {
      const Stretch stretch = neighbours_of(points, i);
      add_piece(points, i, stretch.first, stretch.last);
    }
  }
  TEAMSIGHT_EXPECT(!pieces_.empty());
  end_ = points.back().x;
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  lowest_ = low->y;
  highest_ = high->y;
  index_pieces();
}

void Meridian::index_pieces() {
  std::size_t piece = 0;
  for (std::size_t part = 0; part < kParts; ++part) {
    const double x =
        inner() + (end_ - inner()) * static_cast<double>(part) / static_cast<double>(kParts);
    while (piece + 1 < pieces_.size() && pieces_[piece + 1].from <= x) {
      ++piece;
    }
    piece_at_.push_back(piece);
  }
}

void Meridian::add_piece(const std::vector<vision::ProfilePoint>& points,
                         std::size_t piece,
                         std::size_t first,
                         std::size_t last) {
  const auto count = static_cast<Eigen::Index>(last - first + 1);
  Eigen::MatrixXd powers(count, count);
  Eigen::VectorXd heights(count);
  // Scaled to the piece's width, or the matrix is all but singular.
  const double width = points[piece + 1].x - points[piece].x;
  for (Eigen::Index row = 0; row < count; ++row) {
    const vision::ProfilePoint& point = points[first + static_cast<std::size_t>(row)];
    const double t = (point.x - points[piece].x) / width;
    for (Eigen::Index power = 0; power < count; ++power) {
      powers(row, power) = std::pow(t, static_cast<double>(power));
    }
    heights(row) = point.y - points[piece].y;
  }
  const Eigen::VectorXd solved = powers.partialPivLu().solve(heights);
  Piece made;
  made.from = points[piece].x;
  for (Eigen::Index power = 0; power < count; ++power) {
    made.c[power] = solved(power) / std::pow(width, static_cast<double>(power));
  }
  made.c[0] += points[piece].y;
  pieces_.push_back(made);
}

Meridian::Spot Meridian::at(double x) const {
  const double inside = std::clamp(x, inner(), end_);
  const double share = (inside - inner()) / (end_ - inner());
  std::size_t piece = piece_at_[std::min(
      static_cast<std::size_t>(share * static_cast<double>(kParts)), kParts - 1)];
  while (piece + 1 < pieces_.size() && pieces_[piece + 1].from <= inside) {
    ++piece;
  }
  const Piece& p = pieces_[piece];
  const double t = inside - p.from;
  return {p.c[0] + t * (p.c[1] + t * (p.c[2] + t * p.c[3])),
          p.c[1] + t * (2.0 * p.c[2] + t * 3.0 * p.c[3])};
}

}  // namespace teamsight::sim
