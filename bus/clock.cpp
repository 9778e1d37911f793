// bus/clock.cpp: reads CLOCK_MONOTONIC.
#include "bus/clock.hpp"

#include <ctime>

namespace teamsight::bus {

HostTime host_now() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return HostTime{std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec)};
}

}  // namespace teamsight::bus
