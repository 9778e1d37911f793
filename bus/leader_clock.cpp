// bus/leader_clock.cpp: see bus/leader_clock.hpp.
#include "bus/leader_clock.hpp"

#include <algorithm>
#include <chrono>

namespace teamsight::bus {
namespace {

constexpr Duration kPlausible = std::chrono::seconds(1);

}  // namespace

void LeaderClock::hear(const Sample<WorldModel>& sample) {
  if (!sample.message) return;
  leader_minus_host_ = to_host_time(sample.message->stamp, Duration{0}) - sample.received;
  is_known_ = true;
}

void LeaderClock::hear(const Sample<Explanation>& sample) {
  if (sample.message) clocks_ = sample.message;
}

std::optional<LeaderClock::Moment> LeaderClock::moment_of(RobotId robot,
                                                          PeerTime stamp,
                                                          HostTime now) const {
  if (clocks_) {
    const auto known = std::ranges::find(clocks_->robots, robot, &ExplainedRobot::robot);
    if (known != clocks_->robots.end() && known->clock_sigma > Duration{0}) {
      return Moment{to_host_time(stamp, known->clock_offset), known->clock_sigma};
    }
  }
  const HostTime same = to_host_time(stamp, Duration{0});
  const bool is_plausible = same <= now + kPlausible && same + kPlausible >= now;
  return is_plausible ? std::optional(Moment{same}) : std::nullopt;
}

}  // namespace teamsight::bus
