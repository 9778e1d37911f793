// vision/hough2001/line_hough.hpp: the founding paper's Hough transform [Lima01], steps 2 and 3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/frames.hpp"

namespace teamsight::vision {

/// A straight line x cos(phi) + y sin(phi) = rho around the robot, in R.
struct HoughLine {
  double phi{0.0};  ///< direction of the normal, in [0, pi); rad
  double rho{0.0};  ///< signed distance of the robot; m
  int votes{0};     ///< transition pixels in the accumulator cell
};

/// The accumulator: phi in steps of half a degree, rho in steps of one pixel of the bird's-eye
/// image. The paper counts rho from a corner of the image (125 to 968 px); here it counts from the
/// robot, which is the same lines.
class LineHough {
 public:
  static constexpr int kColumns = 360;  ///< half degrees

  /// @param pixel  m of floor per pixel of the bird's-eye image
  /// @param reach  the farthest line; m
  LineHough(double pixel, double reach);

  /// Votes for all lines through all points. Forgets what was there.
  void vote(std::span<const Point<Robot>> points);

  /// The `count` strongest cells. Cells beside a stronger one (within two degrees and 0.15 m)
  /// belong to the same line and are passed over: the paper does not say how it kept them apart.
  [[nodiscard]] std::vector<HoughLine> strongest(std::size_t count) const;

  /// The strongest lines among a few columns around `phi`, one of each distance.
  ///
  /// @param columns  to each side
  [[nodiscard]] std::vector<HoughLine> strongest_around(double phi,
                                                        int columns,
                                                        std::size_t count) const;

  [[nodiscard]] double pixel() const { return pixel_; }

 private:
  [[nodiscard]] int votes(int column, int row) const {
    return cells_[static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_) +
                  static_cast<std::size_t>(row)];
  }

  [[nodiscard]] double rho_of(int row) const {
    const int middle = rows_ / 2;
    return (row - middle) * pixel_;
  }

  double pixel_;
  int rows_;
  std::vector<std::uint16_t> cells_;  // column by column
  std::vector<double> cosines_;
  std::vector<double> sines_;
};

}  // namespace teamsight::vision
