// fusion/observation.hpp: what fusion takes in: one robot's moment, already in this host's time.
#pragma once

#include <vector>

#include "geometry/identity.hpp"
#include "geometry/sighting.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// One frame of one robot, as it came over the bus.
struct Observation {
  ObservationId id;
  HostTime exposure;           ///< converted from the robot's clock
  Duration sigma_exposure{0};  ///< of that conversion
  PostureEstimate posture;     ///< at `exposure`
  std::vector<BallRay> balls;
  std::vector<ObstacleSighting> obstacles;

  friend bool operator==(const Observation&, const Observation&) = default;
};

}  // namespace teamsight::fusion
