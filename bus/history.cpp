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
  } else if (const auto reason = complaint(*past, id, stamp, received)) {
    return failure(*reason);
  } else if (id.sequence > past->last.sequence) {
    lost = id.sequence - past->last.sequence - 1;
  }
  *past = Past{instance, id, stamp, received, 0, 0, 0, ++clock_};
  return lost;
}

std::optional<Reject> History::complaint(Past& past,
                                         const ObservationId& id,
                                         std::optional<PeerTime> stamp,
                                         HostTime received) {
  if (id.sequence <= past.last.sequence) {
    if (continues(past, id)) return std::nullopt;
    return Reject::kDuplicate;
  }
  if (!stamp || !past.stamp || past.implausible >= kSamplesToRelearn) return std::nullopt;
  const Duration since = received - past.received;
  ++past.implausible;
  if (std::chrono::abs((*stamp - *past.stamp) - since) > kLargestSkew) {
    return Reject::kImplausibleStamp;
  }
  const double ahead = static_cast<double>(id.sequence - past.last.sequence);
  if (ahead > kMostAtOnce + kMostPerSecond * to_seconds(since)) return Reject::kImplausibleNumber;
  return std::nullopt;
}

// Whether what looks old is a writer that goes on counting, and the past what was wrong.
bool History::continues(Past& past, const ObservationId& id) {
  past.rising = id.sequence > past.repeated ? past.rising + 1 : 1;
  past.repeated = id.sequence;
  return past.rising > kSamplesToRelearn;
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
