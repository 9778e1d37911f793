// bench/ping.cpp: the measuring loop of ping.hpp.
#include "bench/ping.hpp"

#include <stdexcept>
#include <thread>

#include "bus/clock.hpp"

namespace teamsight::bench {

PingResult run_pings(const PingPlan& plan, const std::function<bool()>& send_and_wait) {
  std::size_t answered = 0;
  const HostTime give_up = bus::host_now() + std::chrono::seconds(10);
  while (answered < kWarmUp) {
    if (bus::host_now() > give_up) {
      throw std::runtime_error("nobody answers the pings");
    }
    answered += send_and_wait() ? 1U : 0U;
  }
  PingResult result;
  result.round_trips.reserve(plan.count);
  while (result.round_trips.size() + result.lost < plan.count) {
    const HostTime sent = bus::host_now();
    if (send_and_wait()) {
      result.round_trips.push_back(bus::host_now() - sent);
    } else {
      ++result.lost;
    }
    if (plan.pause > Duration{0}) {
      std::this_thread::sleep_for(plan.pause);
    }
  }
  return result;
}

}  // namespace teamsight::bench
