// monitor/link_meter.cpp: see monitor/link_meter.hpp.
#include "monitor/link_meter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace teamsight::monitor {
namespace {

// 5 s at 100 Hz; a robot that sends faster is measured over a shorter time.
constexpr std::size_t kMaxArrivals = 512;

Duration quantile(std::vector<Duration>& values, double share) {
  const std::ptrdiff_t rank = std::lround(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

}  // namespace

void LinkMeter::add(const ObservationId& id,
                    std::optional<Duration> since_exposure,
                    HostTime received) {
  if (id.boot != boot_) arrivals_.clear();
  boot_ = id.boot;
  arrivals_.push_back({id.sequence, received, since_exposure});
  if (arrivals_.size() > kMaxArrivals) arrivals_.pop_front();
  while (arrivals_.front().received + window_ < received) arrivals_.pop_front();
  ++received_;
}

LinkReport LinkMeter::report(HostTime now) const {
  LinkReport report;
  report.received = received_;
  const auto first = std::find_if(arrivals_.begin(), arrivals_.end(), [&](const Arrival& arrival) {
    return arrival.received + window_ >= now;
  });
  if (first == arrivals_.end()) return report;
  const auto count = static_cast<double>(arrivals_.end() - first);
  // From the first arrival to now, not to the last one: the rate of a silent robot falls.
  const double seconds = to_seconds(now - first->received);
  if (count > 1 && seconds > 0) report.rate = (count - 1) / seconds;
  const double sent = static_cast<double>(arrivals_.back().sequence) - first->sequence + 1.0;
  report.loss = sent > count ? 1.0 - count / sent : 0.0;
  set_latency(first, report);
  return report;
}

void LinkMeter::set_latency(const std::deque<Arrival>::const_iterator& first,
                            LinkReport& report) const {
  std::vector<Duration> latencies;
  for (auto it = first; it != arrivals_.end(); ++it) {
    if (!it->since_exposure) return;
    latencies.push_back(*it->since_exposure);
  }
  report.latency_p50 = quantile(latencies, 0.50);
  report.latency_p95 = quantile(latencies, 0.95);
}

}  // namespace teamsight::monitor
