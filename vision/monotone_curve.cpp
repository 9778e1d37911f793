// vision/monotone_curve.cpp: slopes that keep a Hermite curve monotone.
#include "vision/monotone_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

// One-sided slope of the parabola through the three outermost knots, kept from overshooting.
double end_slope(double h0, double h1, double secant0, double secant1) {
  const double slope = ((2.0 * h0 + h1) * secant0 - h0 * secant1) / (h0 + h1);
  return std::clamp(slope, 0.0, 3.0 * secant0);
}

std::vector<double> slopes_of(const std::vector<Knot>& knots) {
  const std::size_t n = knots.size();
  std::vector<double> h;
  std::vector<double> secant;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h.push_back(knots[i + 1].x - knots[i].x);
    secant.push_back((knots[i + 1].y - knots[i].y) / h.back());
  }
  if (n == 2) return {secant[0], secant[0]};
  std::vector<double> slopes(n);
  slopes.front() = end_slope(h[0], h[1], secant[0], secant[1]);
  slopes.back() = end_slope(h[n - 2], h[n - 3], secant[n - 2], secant[n - 3]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    // Weighted harmonic mean: monotone by construction.
    const double w0 = 2.0 * h[i] + h[i - 1];
    const double w1 = h[i] + 2.0 * h[i - 1];
    slopes[i] = (w0 + w1) / (w0 / secant[i - 1] + w1 / secant[i]);
  }
  return slopes;
}

}  // namespace

MonotoneCurve::MonotoneCurve(std::vector<Knot> knots) : knots_(std::move(knots)) {
  TEAMSIGHT_EXPECT(knots_.size() >= 2);
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    TEAMSIGHT_EXPECT(knots_[i].x > knots_[i - 1].x && knots_[i].y > knots_[i - 1].y);
  }
  slopes_ = slopes_of(knots_);
}

std::size_t MonotoneCurve::piece_of(double x) const {
  const auto after = std::ranges::upper_bound(knots_, x, {}, &Knot::x);
  const auto index = static_cast<std::size_t>(after - knots_.begin());
  return std::clamp<std::size_t>(index, 1, knots_.size() - 1) - 1;
}

double MonotoneCurve::at(double x) const {
  if (x <= first().x) return first().y;
  if (x >= last().x) return last().y;
  const std::size_t i = piece_of(x);
  const double h = knots_[i + 1].x - knots_[i].x;
  const double t = (x - knots_[i].x) / h;
  const double s = 1.0 - t;
  return knots_[i].y * (1.0 + 2.0 * t) * s * s + h * slopes_[i] * t * s * s +
         knots_[i + 1].y * t * t * (3.0 - 2.0 * t) - h * slopes_[i + 1] * t * t * s;
}

double MonotoneCurve::slope_at(double x) const {
  const std::size_t i = piece_of(x);
  const double h = knots_[i + 1].x - knots_[i].x;
  const double t = std::clamp((x - knots_[i].x) / h, 0.0, 1.0);
  return 6.0 * t * (1.0 - t) * (knots_[i + 1].y - knots_[i].y) / h +
         slopes_[i] * (1.0 - t) * (1.0 - 3.0 * t) + slopes_[i + 1] * t * (3.0 * t - 2.0);
}

double MonotoneCurve::inverse(double y) const {
  if (y <= first().y) return first().x;
  if (y >= last().y) return last().x;
  const auto after = std::ranges::upper_bound(knots_, y, {}, &Knot::y);
  const auto i = static_cast<std::size_t>(after - knots_.begin());
  double low = knots_[i - 1].x;
  double high = knots_[i].x;
  double x = 0.5 * (low + high);
  for (int step = 0; step < 60 && high - low > 1e-12; ++step) {
    const double excess = at(x) - y;
    (excess > 0.0 ? high : low) = x;
    // Newton where it stays inside the bracket, else halving.
    const double newton = x - excess / std::max(slope_at(x), 1e-300);
    if (std::abs(newton - x) < 1e-13) return newton;
    x = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return x;
}

}  // namespace teamsight::vision
