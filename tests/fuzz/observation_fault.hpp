// tests/fuzz/observation_fault.hpp: numbers that no frame may lead to.
#pragma once

#include <string>

#include "vision/perception.hpp"

namespace teamsight::fuzz {

/// @return the first thing in it that is not finite or out of its range; "" if all is well
[[nodiscard]] std::string fault_of(const vision::FrameObservation& seen);

}  // namespace teamsight::fuzz
