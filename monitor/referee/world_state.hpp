// monitor/referee/world_state.hpp: the team's picture as the league's world state, in the box's
// frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bus/messages.hpp"
#include "geometry/time.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::monitor {

/// What one world state is made of.
struct WorldStateInput {
  std::string team;
  std::string intention;
  const WorldModel* world{nullptr};
  std::vector<const bus::RobotState*> robots;  ///< the newest of each robot, of any order
  Duration age{0};                             ///< how old the world's stamp is now
};

/// One JSON text of the league's world state (MSLWMD), without the NUL at its end; numbers to the
/// millimetre.
///
/// The box's frame: origin the centre mark, x to the right, y to the opponent goal, heading 0 along
/// y, counter-clockwise in [0, 2 pi). A robot that does not know where it is has null for a pose.
[[nodiscard]] std::string world_state(const WorldStateInput& input);

/// What in a text breaks the league's schema; nothing if it may be sent.
[[nodiscard]] std::optional<std::string> fault_of_world_state(const std::string& json);

}  // namespace teamsight::monitor
