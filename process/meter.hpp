// process/meter.hpp: what a process measures of itself and says in its Diagnostics.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "bus/messages.hpp"
#include "bus/reject.hpp"
#include "bus/writer.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"

namespace teamsight::process {

/// Gathers step times and counters and turns them into Diagnostics. Use from one thread.
///
/// `message`, `healthy` and `frame_age_ms` of a report are the caller's to fill in.
class ProcessMeter {
 public:
  /// @param process  name in Diagnostics, e.g. "fusion/3"
  /// @param robot    of the host; kNobody for the coach station
  /// @param boot     of this start of the process (draw_boot_id)
  ProcessMeter(std::string process, RobotId robot, std::uint32_t boot);

  /// One turn of the process took so long.
  void add_step(Duration duration);

  /// Adds to a counter that this meter keeps.
  void count(std::string_view name, std::uint64_t by = 1);

  /// Sets a counter that somebody else keeps.
  void set(std::string_view name, std::uint64_t value);

  /// Sets a number that is a present state and no count: reported before all counters, also when it
  /// is zero.
  void show(std::string_view name, std::uint64_t value);

  /// Sets "<topic>.accepted", "<topic>.lost" and "<topic>.rejected.<reason>".
  void set(std::string_view topic, const bus::ReadCounters& counters);

  /// Sets "<topic>.written", "<topic>.invalid" and "<topic>.failed".
  void set(std::string_view topic, const bus::WriteCounters& counters);

  /// Everything so far; step times and CPU load since the report before.
  ///
  /// After what is shown the counters are those that are not zero, largest first, as many as the
  /// topic holds.
  ///
  /// @param now  the present; the load is 0 in the first report
  [[nodiscard]] bus::Diagnostics report(HostTime now);

 private:
  std::string process_;
  ObservationId id_;
  std::array<Duration, 512> steps_{};  // a ring: the newest steps since the last report
  std::size_t step_count_{0};
  std::map<std::string, std::uint64_t, std::less<>> counters_;
  std::map<std::string, std::uint64_t, std::less<>> shown_;
  HostTime reported_{};
  Duration cpu_at_report_{0};
};

/// Measures one turn of a process: from here to the end of the scope.
class StepTimer {
 public:
  explicit StepTimer(ProcessMeter& meter);
  ~StepTimer();
  StepTimer(const StepTimer&) = delete;
  StepTimer& operator=(const StepTimer&) = delete;

 private:
  ProcessMeter* meter_;
  Duration start_;
};

}  // namespace teamsight::process
