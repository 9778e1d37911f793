// process/rejoin_rule.cpp: see rejoin_rule.hpp.
#include "process/rejoin_rule.hpp"

#include <algorithm>
#include <utility>

namespace teamsight::process {

bool RejoinRule::step(const std::vector<bus::WriterName>& unheard, HostTime peer, HostTime now) {
  const bool has_watched = now - stepped_ <= parameters_.longest_step;
  stepped_ = now;
  if (!has_watched) since_.clear();
  std::map<bus::WriterName, HostTime> since;
  for (const bus::WriterName& name : unheard) {
    const auto known = since_.find(name);
    since[name] = known == since_.end() ? now : known->second;
  }
  since_ = std::move(since);
  std::erase_if(blamed_,
                [&](const auto& entry) { return now - entry.second > parameters_.memory; });
  if (!has_reason(peer, now)) return false;
  for (const auto& [name, first] : since_) blamed_[name] = now;
  since_.clear();
  rejoined_ = now;
  return true;
}

bool RejoinRule::has_reason(HostTime peer, HostTime now) const {
  const Duration since_last = rejoined_ ? now - *rejoined_ : Duration::max();
  if (since_last < parameters_.pause) return false;
  const bool peer_did = peer != HostTime{} && now - peer <= parameters_.patience;
  if (peer_did && since_last >= parameters_.follow) return true;
  return std::any_of(since_.begin(), since_.end(), [&](const auto& entry) {
    return now - entry.second >= parameters_.patience && !blamed_.contains(entry.first);
  });
}

}  // namespace teamsight::process
