// vision/hough2001/field_lines.hpp: the paper's geometric field model (4.3) from a field file.
#pragma once

#include <vector>

#include "geometry/field_model.hpp"

namespace teamsight::vision {

/// Where the field's straight lines are, interrupted ones taken as one: the arrays rho_phi.
struct FieldLines {
  std::vector<double> vertical;    ///< x of the lines parallel to y, ascending; m from the centre
  std::vector<double> horizontal;  ///< y of the lines parallel to x, ascending; m from the centre
  std::vector<double> gaps;        ///< every distance between two parallel lines; m
};

[[nodiscard]] FieldLines field_lines_of(const FieldModel& field);

/// Step 5: how much an angle between two lines speaks for a pair of field lines, in [0, 100]:
/// 100 for parallel ones, falling to 0 within three degrees. @param delta_phi in [0, pi); rad
[[nodiscard]] double relevance_of_angle(double delta_phi);

/// The same for a distance between two lines: 100 for a distance that two parallel field lines
/// have, falling to 0 within 0.15 m. @param delta_rho not negative; m
[[nodiscard]] double relevance_of_distance(const FieldLines& lines, double delta_rho);

}  // namespace teamsight::vision
