// monitor/link_meter.hpp: rate, loss and latency of one robot's frames, over the last seconds.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "geometry/identity.hpp"
#include "geometry/time.hpp"
#include "monitor/update.hpp"

namespace teamsight::monitor {

/// Measures how one robot's Sightings arrive. Loss is what is missing in the sequence numbers.
/// Latency is told only while every frame within the window has one.
class LinkMeter {
 public:
  /// @param window  over which the report is made, > 0
  explicit LinkMeter(Duration window) : window_(window) {}

  /// One frame arrived. A new boot id starts the measurement afresh.
  ///
  /// @param since_exposure  nothing: the robot's clock is not known
  void add(const ObservationId& id, std::optional<Duration> since_exposure, HostTime received);

  [[nodiscard]] LinkReport report(HostTime now) const;

 private:
  struct Arrival {
    std::uint32_t sequence{0};
    HostTime received;
    std::optional<Duration> since_exposure;
  };

  void set_latency(const std::deque<Arrival>::const_iterator& first, LinkReport& report) const;

  Duration window_;
  std::uint32_t boot_{0};
  std::uint64_t received_{0};
  std::deque<Arrival> arrivals_;  // oldest first, at most kMaxArrivals
};

}  // namespace teamsight::monitor
