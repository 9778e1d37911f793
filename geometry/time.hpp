// geometry/time.hpp: clocks that cannot be mixed up.
#pragma once

#include <chrono>

namespace teamsight {

using Duration = std::chrono::nanoseconds;

/// The monotonic clock of one robot's computer (CLOCK_MONOTONIC); zero at some boot.
///
/// Every stamp on the bus is in its sender's host time. No `now()`: code that needs the present
/// takes it as an argument, and the shell reads the clock (bus/clock.hpp).
struct HostClock {
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<HostClock>;
  static constexpr bool is_steady = true;
};

/// Host time of *this* computer, into which the stamps of all peers are converted before fusion.
using HostTime = HostClock::time_point;

/// The monotonic clock of the computer that wrote a sample, as it stands in that sample: another
/// robot's, or the own one when the sample is about to be written.
struct PeerClock {
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<PeerClock>;
  static constexpr bool is_steady = true;
};

using PeerTime = PeerClock::time_point;

/// The stamp that a sample written here and now carries.
[[nodiscard]] constexpr PeerTime stamp_of(HostTime time) {
  return PeerTime{time.time_since_epoch()};
}

/// Host time of a peer's stamp, given how far the peer's clock is ahead of this one.
[[nodiscard]] constexpr HostTime to_host_time(PeerTime stamp, Duration peer_minus_host) {
  return HostTime{stamp.time_since_epoch() - peer_minus_host};
}

/// Seconds as a double, for the mathematics.
[[nodiscard]] constexpr double to_seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

/// Nearest representable duration of so many seconds.
[[nodiscard]] constexpr Duration from_seconds(double seconds) {
  return std::chrono::round<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace teamsight
