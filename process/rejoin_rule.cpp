// process/rejoin_rule.cpp: see rejoin_rule.hpp.
#include "process/rejoin_rule.hpp"

#include <algorithm>
#include <utility>

namespace teamsight::process {

bool RejoinRule::step(const std::vector<Unheard>& unheard, HostTime peer, HostTime now) {
  const bool has_watched = now - stepped_ <= parameters_.longest_step;
  stepped_ = now;
  if (!has_watched) silent_.clear();
  std::map<bus::WriterName, Silence> silent;
  for (const auto& [name, sign] : unheard) {
    const auto known = silent_.find(name);
    silent[name] = {known == silent_.end() ? now : known->second.since, sign};
  }
  silent_ = std::move(silent);
  std::erase_if(blamed_, [&](const auto& entry) {
    return now - entry.second > parameters_.memory && !is_doubtful(entry.first);
  });
  if (!has_reason(peer, now)) return false;
  for (const auto& [name, silence] : silent_) blamed_[name] = now;
  silent_.clear();
  rejoined_ = now;
  return true;
}

bool RejoinRule::has_reason(HostTime peer, HostTime now) const {
  const Duration since_last = rejoined_ ? now - *rejoined_ : Duration::max();
  if (since_last < parameters_.pause) return false;
  const bool peer_did = peer != HostTime{} && now - peer <= parameters_.patience;
  if (peer_did && since_last >= parameters_.follow) return true;
  return std::any_of(silent_.begin(), silent_.end(), [&](const auto& entry) {
    return now - entry.second.since >= patience_with(entry.second.sign) &&
           !blamed_.contains(entry.first);
  });
}

Duration RejoinRule::patience_with(Sign sign) const {
  switch (sign) {
    case Sign::kLeased:
      return parameters_.patience;
    case Sign::kUnanswered:
      return Duration{0};
    case Sign::kBeside:
    case Sign::kDoubtful:
      break;
  }
  return parameters_.quiet_patience;
}

bool RejoinRule::is_doubtful(const bus::WriterName& name) const {
  const auto found = silent_.find(name);
  return found != silent_.end() && found->second.sign == Sign::kDoubtful;
}

}  // namespace teamsight::process
