// bench/play/network.cpp: see bench/play/network.hpp.
#include "bench/play/network.hpp"

namespace teamsight::play {

HostTime host_time(double t) {
  return HostTime{std::chrono::seconds(100)} + from_seconds(t);
}

PeerClockModel::PeerClockModel(const ClockParameters& clocks,
                               const NetworkParameters& network,
                               Random& random)
    : clocks_(clocks),
      network_(network),
      offset_(normal(random, clocks.sigma_offset)),
      drift_(uniform(random, -clocks.max_drift, clocks.max_drift)) {}

PeerTime PeerClockModel::peer_time(double t) const {
  return PeerTime{host_time(t + offset_ + drift_ * t).time_since_epoch()};
}

void PeerClockModel::advance_to(double t, Random& random) {
  while (clocks_.is_unknown && next_exchange_ <= t) {
    const double sent = next_exchange_;
    next_exchange_ += next_exchange_ < 1.0 ? 0.2 : 1.0;
    const double there = sent + uniform(random, network_.min_delay, network_.max_delay);
    const double answered = there + 0.002;
    const double back = answered + uniform(random, network_.min_delay, network_.max_delay);
    estimate_.add({host_time(sent), peer_time(there), peer_time(answered), host_time(back)});
  }
}

std::optional<PeerClockModel::Converted> PeerClockModel::convert(double exposure,
                                                                 double now) const {
  if (!clocks_.is_unknown) return Converted{host_time(exposure), Duration{0}};
  const auto estimate = estimate_.at(host_time(now));
  if (!estimate) return std::nullopt;
  return Converted{to_host_time(peer_time(exposure), estimate->offset), estimate->sigma};
}

std::optional<double> PeerClockModel::error_at(double now) const {
  const auto estimate = estimate_.at(host_time(now));
  if (!estimate) return std::nullopt;
  return to_seconds(estimate->offset) - (offset_ + drift_ * now);
}

}  // namespace teamsight::play
