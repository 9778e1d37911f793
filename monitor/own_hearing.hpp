// monitor/own_hearing.hpp: the station joins the bus anew when it must, and says so in its log.
#pragma once

#include <cstdint>
#include <vector>

#include "bus/loop.hpp"
#include "monitor/feeds.hpp"
#include "monitor/station.hpp"
#include "process/hearing.hpp"
#include "process/meter.hpp"

namespace teamsight::monitor {

/// process::Hearing, and what the operator reads of it: the station does not hear its own report.
class OwnHearing {
 public:
  OwnHearing(bus::Participant& team, const Feeds& feeds, bus::Loop& loop) : hearing_(team) {
    feeds.watch(hearing_);
    hearing_.attach(loop);
  }

  /// These robots are heard and let an order wait: perhaps they do not hear the station.
  void note_unanswered(const std::vector<RobotId>& robots) {
    for (const RobotId robot : robots) hearing_.note_unanswered(robot);
  }

  /// The station's report on itself, with what there is to say about this; a new time is logged.
  [[nodiscard]] bus::Diagnostics report(process::ProcessMeter& meter,
                                        Station& station,
                                        HostTime now) {
    meter.set("bus.rejoined", hearing_.times());
    bus::Diagnostics report = meter.report(now);
    hearing_.tell(report, now);
    if (hearing_.times() != logged_) {
      station.note(now, Level::kAlarm, "The station " + report.message);
    }
    logged_ = hearing_.times();
    return report;
  }

 private:
  process::Hearing hearing_;
  std::uint64_t logged_{0};
};

}  // namespace teamsight::monitor
