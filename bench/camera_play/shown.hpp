// bench/camera_play/shown.hpp: which of the true things a camera's report is about.
#pragma once

#include <cstddef>

#include "bench/play/eyes.hpp"

namespace teamsight::camera_play {

/// Fills in which true balls and players the frame's report shows, by where they truly stand around
/// the true robot: its own idea of its posture does not matter. A ball is shown by a ray within
/// 0.3 m of its centre, a player by an obstacle within 0.5 m of its axis.
void tell_shown(const play::Moment& moment,
                std::size_t robot,
                double robot_radius,
                play::Frame& frame);

}  // namespace teamsight::camera_play
