// vision/mirror_profile.cpp: natural cubic spline.
#include "vision/mirror_profile.hpp"

#include <algorithm>

#include "geometry/expect.hpp"

namespace teamsight::vision {

MirrorProfile::MirrorProfile(const std::vector<ProfilePoint>& points)
    : points_(points),
      bend_(points.size(), 0.0) {
  TEAMSIGHT_EXPECT(points_.size() >= 2);
  const std::size_t n = points_.size();
  // Thomas' algorithm on the tridiagonal system of the second derivatives.
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double h0 = points_[i].x - points_[i - 1].x;
    const double h1 = points_[i + 1].x - points_[i].x;
    TEAMSIGHT_EXPECT(h0 > 0.0 && h1 > 0.0);
    const double jump =
        6.0 * ((points_[i + 1].y - points_[i].y) / h1 - (points_[i].y - points_[i - 1].y) / h0);
    const double pivot = 2.0 * (h0 + h1) - h0 * upper[i - 1];
    upper[i] = h1 / pivot;
    bend_[i] = (jump - h0 * bend_[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) bend_[i] -= upper[i] * bend_[i + 1];
}

std::size_t MirrorProfile::piece_of(double x) const {
  const auto after = std::ranges::upper_bound(points_, x, {}, &ProfilePoint::x);
  const auto index = static_cast<std::size_t>(after - points_.begin());
  return std::clamp<std::size_t>(index, 1, points_.size() - 1) - 1;
}

double MirrorProfile::height(double x) const {
  x = std::clamp(x, inner(), outer());
  const std::size_t i = piece_of(x);
  const double h = points_[i + 1].x - points_[i].x;
  const double a = (points_[i + 1].x - x) / h;
  const double b = 1.0 - a;
  return a * points_[i].y + b * points_[i + 1].y +
         ((a * a * a - a) * bend_[i] + (b * b * b - b) * bend_[i + 1]) * h * h / 6.0;
}

double MirrorProfile::slope(double x) const {
  x = std::clamp(x, inner(), outer());
  const std::size_t i = piece_of(x);
  const double h = points_[i + 1].x - points_[i].x;
  const double a = (points_[i + 1].x - x) / h;
  const double b = 1.0 - a;
  return (points_[i + 1].y - points_[i].y) / h +
         ((1.0 - 3.0 * a * a) * bend_[i] + (3.0 * b * b - 1.0) * bend_[i + 1]) * h / 6.0;
}

}  // namespace teamsight::vision
