// bench/fuse_score/claims.hpp: what single frames say beside the truth, before any fusion.
#pragma once

#include <array>

#include "bench/fuse_score/tally.hpp"
#include "bench/play/play_log.hpp"

namespace teamsight::score {

/// Of the frames of sound robots whose posture is not lost. A sighting belongs to what is true and
/// nearest around the true robot: a ray within 0.3 m of a ball's centre, an obstacle within 0.5 m
/// of a player; any other is false. Sightings that fusion leaves out for their confidence do not
/// count.
struct ClaimTally {
  static constexpr std::array<double, 3> kRings{3.0, 6.0, 9.0};  ///< ends of the rings; m

  ErrorTally posture;      ///< position
  MeanTally posture_nees;  ///< of (x, y, theta), per degree of freedom
  MeanTally ray_nees;      ///< of a ball's direction, likewise
  MeanTally radius_nees;   ///< of its angular radius
  ErrorTally obstacle;     ///< foot against the nearest point of the player's body
  MeanTally obstacle_nees;
  std::array<MeanTally, kRings.size()> balls_shown;  ///< share of true ones, by distance
  std::array<MeanTally, kRings.size()> players_shown;
  MeanTally false_balls;  ///< per frame
  MeanTally false_obstacles;

  void merge(const ClaimTally& other);
};

[[nodiscard]] ClaimTally count_claims(const play::PlayLog& log);

}  // namespace teamsight::score
