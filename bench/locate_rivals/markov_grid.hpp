// bench/locate_rivals/markov_grid.hpp: Markov localisation on a grid, as the paper names it.
#pragma once

#include <span>
#include <vector>

#include "bench/locate_rivals/distance_table.hpp"
#include "geometry/field_model.hpp"
#include "geometry/pose.hpp"
#include "vision/line_points.hpp"

namespace teamsight::locate_rivals {

struct MarkovParameters {
  double cell{0.1};          ///< m
  int headings{72};          ///< of 5 degrees
  double sigma_point{0.10};  ///< m
  double fails{0.2};         ///< share of points that are anything
  double independent{0.2};   ///< exponent: neighbouring points are alike
};

/// The probability of every cell of (x, y, theta) after one image, from no knowledge [Burgard96]; a
/// symmetric field has two equal maxima.
///
/// @return the mean around the most probable cell
[[nodiscard]] Pose<Field, Robot> markov_localise(const DistanceTable& table,
                                                 const FieldModel& field,
                                                 std::span<const vision::LinePoint> points,
                                                 const MarkovParameters& parameters = {});

}  // namespace teamsight::locate_rivals
