// vision/mirror_profile.cpp: natural cubic spline, as polynomials that are found without a search.
#include "vision/mirror_profile.hpp"

#include <algorithm>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

constexpr double kKink = 1e-7;  // m; where two points are this near, the tangent jumps

// Between parts of a mirror: the spline ends here and begins anew.
bool is_at_kink(const std::vector<ProfilePoint>& points, std::size_t i) {
  const bool before = i > 0 && points[i].x - points[i - 1].x < kKink;
  return before || (i + 1 < points.size() && points[i + 1].x - points[i].x < kKink);
}

// Second derivatives at the points: Thomas' algorithm on the tridiagonal system.
std::vector<double> bends_of(const std::vector<ProfilePoint>& points) {
  const std::size_t n = points.size();
  std::vector<double> bend(n, 0.0);
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double h0 = points[i].x - points[i - 1].x;
    const double h1 = points[i + 1].x - points[i].x;
    TEAMSIGHT_EXPECT(h0 > 0.0 && h1 > 0.0);
    if (is_at_kink(points, i)) continue;
    const double jump =
        6.0 * ((points[i + 1].y - points[i].y) / h1 - (points[i].y - points[i - 1].y) / h0);
    const double pivot = 2.0 * (h0 + h1) - h0 * upper[i - 1];
    upper[i] = h1 / pivot;
    bend[i] = (jump - h0 * bend[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) bend[i] -= upper[i] * bend[i + 1];
  return bend;
}

}  // namespace

MirrorProfile::MirrorProfile(const std::vector<ProfilePoint>& points) {
  TEAMSIGHT_EXPECT(points.size() >= 2);
  add_pieces(points, bends_of(points));
  outer_ = points.back().x;
  index_pieces();
}

void MirrorProfile::add_pieces(const std::vector<ProfilePoint>& points,
                               const std::vector<double>& bend) {
  pieces_.reserve(points.size() - 1);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double h = points[i + 1].x - points[i].x;
    const double secant = (points[i + 1].y - points[i].y) / h;
    pieces_.push_back({points[i].x,
                       points[i].y,
                       secant - (2.0 * bend[i] + bend[i + 1]) * h / 6.0,
                       0.5 * bend[i],
                       (bend[i + 1] - bend[i]) / (6.0 * h)});
  }
}

// Twice as many parts as pieces: from the part's first piece it is hardly ever far.
void MirrorProfile::index_pieces() {
  const std::size_t parts = 2 * pieces_.size();
  parts_per_metre_ = static_cast<double>(parts) / (outer() - inner());
  piece_at_.reserve(parts + 1);
  std::uint32_t piece = 0;
  for (std::size_t part = 0; part <= parts; ++part) {
    const double x = inner() + static_cast<double>(part) / parts_per_metre_;
    while (piece + 1 < pieces_.size() && pieces_[piece + 1].from <= x) ++piece;
    piece_at_.push_back(piece);
  }
}

MirrorProfile::Spot MirrorProfile::at(double x) const {
  const double inside = std::clamp(x, inner(), outer_);
  std::size_t i = piece_at_[static_cast<std::size_t>((inside - inner()) * parts_per_metre_)];
  while (i + 1 < pieces_.size() && pieces_[i + 1].from <= inside) ++i;
  const Piece& piece = pieces_[i];
  const double t = inside - piece.from;
  const double slope = piece.c1 + t * (2.0 * piece.c2 + t * 3.0 * piece.c3);
  return {piece.c0 + t * (piece.c1 + t * (piece.c2 + t * piece.c3)) + slope * (x - inside), slope};
}

}  // namespace teamsight::vision
