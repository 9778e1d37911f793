// bus/history.cpp: what is plausible after what was heard before.
#include "bus/history.hpp"

#include <algorithm>

namespace teamsight::bus {

History::History() {
  pasts_.reserve(kWriters);
}

Result<std::uint32_t, Reject> History::judge(std::uint64_t instance,
                                             const ObservationId& id,
                                             std::optional<PeerTime> stamp,
                                             HostTime received) {
  Past* past = find(instance, id);
  std::uint32_t lost = 0;
  if (past == nullptr) {
    past = &remember_new();
  } else {
    if (id.sequence <= past->last.sequence) return failure(Reject::kDuplicate);
    if (stamp && !is_plausible(*past, *stamp, received)) {
      ++past->implausible;
      return failure(Reject::kImplausibleStamp);
    }
    lost = id.sequence - past->last.sequence - 1;
  }
  *past = Past{instance, id, stamp, received, 0, ++clock_};
  return lost;
}

bool History::is_plausible(const Past& past, PeerTime stamp, HostTime received) {
  if (!past.stamp || past.implausible >= kSamplesToRelearn) return true;
  return std::chrono::abs((stamp - *past.stamp) - (received - past.received)) <= kLargestSkew;
}

History::Past* History::find(std::uint64_t instance, const ObservationId& id) {
  const auto found = std::find_if(pasts_.begin(), pasts_.end(), [&](const Past& past) {
    return past.instance == instance && past.last.robot == id.robot && past.last.boot == id.boot;
  });
  return found == pasts_.end() ? nullptr : &*found;
}

History::Past& History::remember_new() {
  if (pasts_.size() < kWriters) return pasts_.emplace_back();
  return *std::min_element(
      pasts_.begin(), pasts_.end(), [](const Past& a, const Past& b) { return a.used < b.used; });
}

}  // namespace teamsight::bus
