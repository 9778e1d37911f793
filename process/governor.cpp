// process/governor.cpp: see governor.hpp.
#include "process/governor.hpp"

#include <algorithm>

namespace teamsight::process {
namespace {

// More than a team has processes: forged names cannot fill the memory.
constexpr std::size_t kMaxProcesses = 64;

}  // namespace

std::string_view to_text(Thrift thrift) {
  switch (thrift) {
    case Thrift::kNone:
      return "";
    case Thrift::kRareDiagnostics:
      return "air is full: fewer diagnostics";
    case Thrift::kNearObstacles:
      return "air is full: no raw obstacles far from the ball";
    case Thrift::kSlowWorld:
      return "air is full: world model at 15 Hz";
    case Thrift::kNoObstacles:
      return "air is full: no raw obstacles";
  }
  return "";
}

Governor::Governor(const GovernorParameters& parameters) : parameters_(parameters) {}

void Governor::heard(std::string_view process, double bps, HostTime now) {
  auto found = shares_.find(process);
  if (found == shares_.end()) {
    std::erase_if(shares_,
                  [&](const auto& entry) { return now - entry.second.heard > parameters_.memory; });
    if (shares_.size() >= kMaxProcesses) return;
    found = shares_.emplace(std::string(process), Share{bps, bps, now, now}).first;
  }
  Share& share = found->second;
  share = Share{bps, share.bps, now, share.first};
}

double Governor::team_bps(HostTime now) const {
  double sum = 0.0;
  for (const auto& [process, share] : shares_) {
    if (now - share.heard <= parameters_.memory) sum += share.bps;
  }
  return sum;
}

// A second ahead, if what rises goes on to rise; of those who have settled.
double Governor::forecast_bps(HostTime now) const {
  double sum = 0.0;
  for (const auto& [process, share] : shares_) {
    if (now - share.heard > parameters_.memory) continue;
    if (now - share.first < parameters_.settling) continue;
    sum += share.bps + std::max(0.0, share.bps - share.before_bps);
  }
  return sum;
}

Thrift Governor::step(HostTime now) {
  const auto level = static_cast<int>(thrift_);
  if (forecast_bps(now) > parameters_.begin * parameters_.budget_bps) {
    not_calm_ = now;
    if (thrift_ != kMostThrift) thrift_ = static_cast<Thrift>(level + 1);
  } else if (team_bps(now) > parameters_.end * parameters_.budget_bps) {
    not_calm_ = now;
  } else if (level > 0 && now - not_calm_ >= parameters_.calm) {
    not_calm_ = now;  // one step in `calm`
    thrift_ = static_cast<Thrift>(level - 1);
  }
  return thrift_;
}

}  // namespace teamsight::process
