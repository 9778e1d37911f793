// vision/mirror_profile.hpp: a mirror's meridian as a smooth curve with slope.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// The meridian y(x) of a mirror, x from the axis outwards, y from the pinhole; m.
///
/// A natural cubic spline through the given points: the slope decides where a ray goes, so it must
/// be continuous. Where two points are less than 0.1 um apart a new part begins and the slope may
/// jump. At the apex (x = 0) the slope is that of the given points, not forced to 0: a
/// cone is a mirror too.
class MirrorProfile {
 public:
  /// @pre at least two points by strictly growing x
  explicit MirrorProfile(const std::vector<ProfilePoint>& points);

  /// A place on the curve.
  struct Spot {
    double height{0.0};  ///< m
    double slope{0.0};   ///< dy/dx
  };

  /// @param x  beyond the profile it goes on along its tangent
  [[nodiscard]] Spot at(double x) const;

  [[nodiscard]] double height(double x) const { return at(x).height; }

  [[nodiscard]] double inner() const { return pieces_.front().from; }

  [[nodiscard]] double outer() const { return outer_; }

 private:
  /// Between two points: y = c0 + t (c1 + t (c2 + t c3)), t = x - from.
  struct Piece {
    double from{0.0};
    double c0{0.0};
    double c1{0.0};
    double c2{0.0};
    double c3{0.0};
  };

  void add_pieces(const std::vector<ProfilePoint>& points, const std::vector<double>& bend);
  void index_pieces();

  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> piece_at_;  // of equal parts of the width: the first that reaches in
  double outer_{0.0};
  double parts_per_metre_{0.0};
};

}  // namespace teamsight::vision
