// monitor/other_stations.hpp: the coach stations that are heard beside this one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "geometry/time.hpp"

namespace teamsight::monitor {

/// Tells stations apart by the boot ids that they speak under. A value; no clock.
class OtherStations {
 public:
  /// @param gone_after  one that says nothing for so long is gone
  explicit OtherStations(Duration gone_after) : gone_after_(gone_after) {}

  /// One of them speaks.
  ///
  /// @return whether it was not there before
  bool hear(std::uint32_t boot, HostTime now) {
    std::erase_if(heard_, [&](const auto& one) { return now - one.second >= gone_after_; });
    const auto known = heard_.find(boot);
    if (known != heard_.end()) {
      known->second = now;
      return false;
    }
    return heard_.size() < kMost && heard_.emplace(boot, now).second;
  }

  /// How many are there.
  [[nodiscard]] std::uint32_t count(HostTime now) const {
    std::uint32_t count = 0;
    for (const auto& [boot, heard] : heard_) {
      if (now - heard < gone_after_) ++count;
    }
    return count;
  }

 private:
  static constexpr std::size_t kMost = 16;  // more than a team has; strangers cannot fill memory

  Duration gone_after_;
  std::map<std::uint32_t, HostTime> heard_;
};

}  // namespace teamsight::monitor
