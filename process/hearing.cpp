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

/// Whether two writers are one process's: the name begins with its participant's.
bool are_of_one_process(const bus::WriterName& a, const bus::WriterName& b) {
  constexpr std::size_t kParticipant = 12;
  return std::equal(a.begin(), a.begin() + kParticipant, b.begin());
}

}  // namespace

Hearing::Hearing(bus::Participant& team, const RejoinParameters& parameters)
    : team_(&team),
      rule_(parameters) {}

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
  std::vector<Unheard> unheard;
  HostTime peer{};
  for (const Ear& ear : ears_) {
    listen(ear, now, unheard);
    peer = std::max(peer, ear.renamed());
  }
  for (const RobotId robot : unanswered_) unheard.push_back({{robot}, Sign::kUnanswered});
  unanswered_.clear();
  if (!rule_.step(unheard, peer, now)) return;
  ++times_;
  last_ = now;
  is_out_ = !team_->rejoin();
}

void Hearing::listen(const Ear& ear, HostTime now, std::vector<Unheard>& unheard) {
  const auto silent = ear.unheard(now);
  if (silent.empty()) return;
  std::vector<bus::WriterName> heard;
  for (const Names& witness : ear.witnesses) {
    for (const bus::WriterName& name : witness(now)) heard.push_back(name);
  }
  for (const bus::WriterName& name : silent) {
    const auto is_same = [&](const auto& other) {
      return are_of_one_process(name, other);
    };
    if (std::any_of(heard.begin(), heard.end(), is_same)) {
      unheard.push_back({name, Sign::kBeside});
    } else if (ear.unwitnessed) {
      unheard.push_back({name, *ear.unwitnessed});
    }
  }
}

void Hearing::tell(bus::Diagnostics& report, HostTime now) const {
  if (times_ == 0 || now - last_ > kTold || !report.message.empty()) return;
  report.healthy = false;
  report.message = "joined the bus anew (" + std::to_string(times_) +
                   "): somebody lived unheard. Forged packets? Turn security on";
}

}  // namespace teamsight::process
