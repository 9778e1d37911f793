// bench/locate_score/line_view.hpp: line points as a scanning camera with known faults sees them.
#pragma once

#include <random>
#include <vector>

#include "geometry/field_model.hpp"
#include "geometry/pose.hpp"
#include "vision/line_points.hpp"

namespace teamsight::locate_score {

/// How a field is looked at.
struct LineViewParameters {
  int rays{120};
  double range{6.0};          ///< m
  double sigma{0.01};         ///< of a point, in each direction; m
  double claimed_sigma{0.0};  ///< what the points claim; 0: the truth
  double outliers{0.0};       ///< share of points that lie anywhere within the range
  double hidden{0.0};         ///< share of the lines' length that is not seen, in pieces of 1 m
  double eye_height{0.75};    ///< m
  double roll{0.0};           ///< of the head, that the camera does not know; rad
  double pitch{0.0};          ///< rad
  int robots{0};              ///< that stand around and hide a sector each
};

/// A faulty map from the floor to where the camera takes it to be; smooth, the same in all frames.
struct MapFault {
  double shift_x{0.0};  ///< m at all ranges: a camera aside from the robot's axis
  double shift_y{0.0};
  double turn{0.0};   ///< rad
  double scale{0.0};  ///< of the range; dimensionless
  double bend{0.0};   ///< m at the far end, as the square of the range, with twice the azimuth

  [[nodiscard]] Point<Robot> seen(const Point<Robot>& p_R, double range) const;
};

/// One look. All points in the order of the rays, from near to far.
[[nodiscard]] std::vector<vision::LinePoint> look_at_lines(const FieldModel& field,
                                                           const Pose<Field, Robot>& X_FR,
                                                           const LineViewParameters& parameters,
                                                           const MapFault& fault,
                                                           std::mt19937& random);

/// Anywhere on the field, `margin` away from the outer lines.
[[nodiscard]] Pose<Field, Robot> draw_pose(const FieldModel& field,
                                           double margin,
                                           std::mt19937& random);

}  // namespace teamsight::locate_score
