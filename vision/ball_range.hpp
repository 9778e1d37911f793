// vision/ball_range.hpp: how far a ball is along its ray, by the floor and by its size.
#pragma once

#include "geometry/sighting.hpp"

namespace teamsight::vision {

/// A ball's range by two ways that go wrong differently. One that flies looks larger than a ball on
/// the floor at the end of its ray; one that lies there does not.
struct BallRange {
  double on_floor{0.0};        ///< m along the ray to a ball on the floor; 0: none can lie on it
  double sigma_on_floor{0.0};  ///< m
  double by_size{0.0};         ///< m along the ray; 0: the size is not measured
  double sigma_by_size{0.0};   ///< m
  /// Log-likelihood ratio of the ball's size, in the air against on the floor; 0: it says nothing.
  double flying_log_odds{0.0};

  friend bool operator==(const BallRange&, const BallRange&) = default;
};

/// What is known of balls and of the head beforehand.
struct BallRangeRules {
  double ball_radius{0.11};   ///< m
  double sigma_lean{0.0052};  ///< of the head, about any level axis; rad
  double nearest{0.3};        ///< m from the mirror; a ball in the air is not nearer
  double farthest{15.0};      ///< m; one on the floor is not seen beyond
};

/// On the floor's side: the elevation's uncertainty and the head's. On the size's: what the ray
/// says of its angular radius. In the air any range before the floor's is as probable as another.
///
/// @pre ray.ray_R.direction has unit length
[[nodiscard]] BallRange range_of(const BallRay& ray, const BallRangeRules& rules = {});

}  // namespace teamsight::vision
