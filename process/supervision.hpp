// process/supervision.hpp: telling the one that started this process (systemd) that it is well.
#pragma once

#include "bus/loop.hpp"

namespace teamsight::process {

/// Says "ready" now and "alive" as long as the loop turns; without a supervisor it does nothing.
///
/// From the loop, so that a loop that hangs is silent and its process started again. The protocol
/// is that of sd_notify(3), which promises to stay. If TEAMSIGHT_LOCK_MEMORY is set, it also keeps
/// all memory of the process from being paged out.
///
/// @param loop  the process's main loop, everything else already attached
/// @throws std::runtime_error if memory must be locked and cannot
void report_to_supervisor(bus::Loop& loop);

}  // namespace teamsight::process
