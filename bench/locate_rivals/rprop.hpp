// bench/locate_rivals/rprop.hpp: the classical matching of line points, as the league's teams run
// it.
#pragma once

#include <span>

#include "bench/locate_rivals/distance_table.hpp"
#include "geometry/pose.hpp"
#include "vision/line_points.hpp"

namespace teamsight::locate_rivals {

/// The constants published with CAMBADA's agent (VisualPositionOptimiser, from Osnabrueck Tribots).
struct RpropParameters {
  int steps{10};             ///< with more than twenty points
  int steps_few{20};         ///< with fewer
  double width{0.25};        ///< c of the error 1 - c^2 / (c^2 + d^2); m
  double far2{100.0};        ///< d^2 of the weight (1.5 m^2 + d^2) / (d^2 + r^2); m^2
  double first_place{0.04};  ///< m
  double first_turn{0.1};    ///< rad
  double grow{1.2};
  double shrink{0.5};
};

/// Ten steps of RPROP on the table [Lauer05]; the best posture of all steps.
[[nodiscard]] Pose<Field, Robot> rprop(const DistanceTable& table,
                                       std::span<const vision::LinePoint> points,
                                       const Pose<Field, Robot>& start,
                                       const RpropParameters& parameters = {});

}  // namespace teamsight::locate_rivals
