// sim/render/meridian.hpp: the curve that turns about the axis and makes the mirror.
#pragma once

#include <cstddef>
#include <vector>

#include "vision/camera_parameters.hpp"

namespace teamsight::sim {

/// A mirror's meridian between given points: through each four neighbours goes one cubic, so that
/// every piece depends on what is near only; pieces never reach over a kink (two points less than
/// 0.1 um apart).
class Meridian {
 public:
  /// @pre at least two points by growing x
  explicit Meridian(const std::vector<vision::ProfilePoint>& points);

  struct Spot {
    double height{0.0};
    double slope{0.0};
  };

  /// @param x clamped to the curve; m
  [[nodiscard]] Spot at(double x) const;

  [[nodiscard]] double inner() const { return pieces_.front().from; }

  [[nodiscard]] double outer() const { return end_; }

  [[nodiscard]] double lowest() const { return lowest_; }

  [[nodiscard]] double highest() const { return highest_; }

 private:
  // y = c0 + c1 t + c2 t^2 + c3 t^3 with t = x - from.
  struct Piece {
    double from{0.0};
    double c[4]{};
  };

  void index_pieces();
  void add_piece(const std::vector<vision::ProfilePoint>& points,
                 std::size_t piece,
                 std::size_t first,
                 std::size_t last);

  std::vector<Piece> pieces_;
  std::vector<std::size_t> piece_at_;  // of the equal parts of the width, where to start looking
  double end_{0.0};
  double lowest_{0.0};
  double highest_{0.0};
};

}  // namespace teamsight::sim
