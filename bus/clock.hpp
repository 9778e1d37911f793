// bus/clock.hpp: the one place where the present is read.
#pragma once

#include "geometry/time.hpp"

namespace teamsight::bus {

/// The present in host time (CLOCK_MONOTONIC): no step of the wall clock moves it.
[[nodiscard]] HostTime host_now() noexcept;

}  // namespace teamsight::bus
