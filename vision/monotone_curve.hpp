// vision/monotone_curve.hpp: a smooth growing curve through given knots, and its inverse.
#pragma once

#include <cstddef>
#include <vector>

namespace teamsight::vision {

/// A place on a MonotoneCurve.
struct Knot {
  double x{0.0};
  double y{0.0};
};

/// Cubic Hermite interpolation that grows wherever its knots do [Fritsch80].
class MonotoneCurve {
 public:
  /// @pre at least two knots, x and y strictly growing
  explicit MonotoneCurve(std::vector<Knot> knots);

  /// @param x within [first, last]; beyond, the end's value
  [[nodiscard]] double at(double x) const;

  /// @param x within [first, last]
  [[nodiscard]] double slope_at(double x) const;

  /// The x at which the curve reaches `y`; beyond the ends, the end's x.
  [[nodiscard]] double inverse(double y) const;

  [[nodiscard]] const Knot& first() const { return knots_.front(); }

  [[nodiscard]] const Knot& last() const { return knots_.back(); }

 private:
  [[nodiscard]] std::size_t piece_of(double x) const;

  std::vector<Knot> knots_;
  std::vector<double> slopes_;
};

}  // namespace teamsight::vision
