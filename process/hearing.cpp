// process/hearing.cpp: see hearing.hpp.
#include "process/hearing.hpp"

#include <algorithm>
#include <string>

#include "bus/clock.hpp"

namespace teamsight::process {
namespace {

constexpr Duration kPeriod = std::chrono::milliseconds(500);
constexpr double kJitter = 0.2;
constexpr Duration kTold = std::chrono::seconds(30);

}  // namespace

Hearing::Hearing(bus::Participant& team) : team_(&team), rule_(RejoinParameters{}) {}

void Hearing::attach(bus::Loop& loop) {
  loop.every(
      kPeriod, [this] { look(bus::host_now()); }, kJitter);
}

void Hearing::look(HostTime now) {
  if (team_->is_secured()) return;
  if (is_out_) {
    is_out_ = !team_->rejoin();
    return;
  }
  std::vector<bus::WriterName> unheard;
  HostTime peer{};
  for (const Ear& ear : ears_) {
    for (const bus::WriterName& name : ear.unheard(now)) unheard.push_back(name);
    peer = std::max(peer, ear.renamed());
  }
  if (!rule_.step(unheard, peer, now)) return;
  ++times_;
  last_ = now;
  is_out_ = !team_->rejoin();
}

void Hearing::tell(bus::Diagnostics& report, HostTime now) const {
  if (times_ == 0 || now - last_ > kTold || !report.message.empty()) return;
  report.healthy = false;
  report.message = "joined the bus anew (" + std::to_string(times_) +
                   "): somebody lived unheard. Forged packets? Turn security on";
}

}  // namespace teamsight::process
