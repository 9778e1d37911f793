// client/world.hpp: what a behaviour program is handed: a world model, whose it is and its age.
#pragma once

#include <cstdint>

#include "geometry/time.hpp"
#include "geometry/world_model.hpp"

namespace teamsight {

/// Whose world model it is.
enum class Source : std::uint8_t {
  kNone,     ///< nobody's: no fusion is heard
  kLeader,   ///< the leading fusion's, the same in every robot
  kOwnHost,  ///< this robot's own fusion's, since no leader is heard
};

/// The freshest world model that there is.
struct World {
  Source source{Source::kNone};
  WorldModel model;  ///< empty if the source is kNone
  /// Since the moment the model speaks of. Of the leader's: since the quickest such model would
  /// have been here, so a few ms too young on a network.
  Duration age{0};
};

}  // namespace teamsight
