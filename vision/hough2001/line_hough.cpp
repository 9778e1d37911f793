// vision/hough2001/line_hough.cpp: votes and maxima.
#include "vision/hough2001/line_hough.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teamsight::vision {

namespace {

constexpr double kColumnAngle = std::numbers::pi / LineHough::kColumns;
constexpr double kSameAngle = 2.0 * std::numbers::pi / 180.0;
constexpr double kSameDistance = 0.15;  // m
constexpr int kFewestVotes = 6;

bool is_same(const HoughLine& a, const HoughLine& b) {
  const double gap = std::abs(a.phi - b.phi);
  if (gap < kSameAngle) return std::abs(a.rho - b.rho) < kSameDistance;
  // Beyond 180 degrees the same line comes back with the other sign.
  return std::numbers::pi - gap < kSameAngle && std::abs(a.rho + b.rho) < kSameDistance;
}

// Takes the best of `cells` that are not beside a better one.
std::vector<HoughLine> pick(std::vector<HoughLine>& cells, std::size_t count) {
  std::ranges::stable_sort(cells, [](const auto& a, const auto& b) { return a.votes > b.votes; });
  std::vector<HoughLine> lines;
  for (const HoughLine& cell : cells) {
    if (lines.size() == count) break;
    const bool is_known =
        std::ranges::any_of(lines, [&](const auto& line) { return is_same(line, cell); });
    if (!is_known) lines.push_back(cell);
  }
  return lines;
}

}  // namespace

LineHough::LineHough(double pixel, double reach)
    : pixel_(pixel),
      rows_(2 * static_cast<int>(std::ceil(reach / pixel)) + 1),
      cells_(static_cast<std::size_t>(kColumns) * static_cast<std::size_t>(rows_)) {
  for (int column = 0; column < kColumns; ++column) {
    cosines_.push_back(std::cos(column * kColumnAngle));
    sines_.push_back(std::sin(column * kColumnAngle));
  }
}

void LineHough::vote(std::span<const Point<Robot>> points) {
  std::ranges::fill(cells_, std::uint16_t{0});
  for (const Point<Robot>& p : points) {
    for (std::size_t column = 0; column < kColumns; ++column) {
      const double rho = p.x * cosines_[column] + p.y * sines_[column];
      const int row = static_cast<int>(std::lround(rho / pixel_)) + rows_ / 2;
      if (row < 0 || row >= rows_) continue;
      ++cells_[column * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row)];
    }
  }
}

std::vector<HoughLine> LineHough::strongest(std::size_t count) const {
  std::vector<HoughLine> cells;
  for (int column = 0; column < kColumns; ++column) {
    for (int row = 0; row < rows_; ++row) {
      const int n = votes(column, row);
      if (n >= kFewestVotes) cells.push_back({column * kColumnAngle, rho_of(row), n});
    }
  }
  return pick(cells, count);
}

std::vector<HoughLine> LineHough::strongest_around(double phi,
                                                   int columns,
                                                   std::size_t count) const {
  const int middle = static_cast<int>(std::lround(phi / kColumnAngle));
  std::vector<HoughLine> cells;
  for (int offset = -columns; offset <= columns; ++offset) {
    // Columns repeat after 180 degrees with the distance turned round.
    const int turns = static_cast<int>(std::floor((middle + offset) / double{kColumns}));
    const int column = middle + offset - turns * kColumns;
    const double sign = turns % 2 == 0 ? 1.0 : -1.0;
    for (int row = 0; row < rows_; ++row) {
      const int n = votes(column, row);
      if (n >= kFewestVotes) cells.push_back({phi, sign * rho_of(row), n});
    }
  }
  return pick(cells, count);
}

}  // namespace teamsight::vision
