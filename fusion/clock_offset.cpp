// fusion/clock_offset.cpp: see fusion/clock_offset.hpp.
#include "fusion/clock_offset.hpp"

#include <cmath>
#include <numbers>

namespace teamsight::fusion {

bool ClockOffset::add(const ClockExchange& exchange) {
  const Duration there = exchange.echo_sent - exchange.probe_received;
  const Duration trip = exchange.echo_received - exchange.probe_sent - there;
  if (there < Duration{0} || trip < Duration{0}) return false;
  const Duration out =
      exchange.probe_received.time_since_epoch() - exchange.probe_sent.time_since_epoch();
  const Duration back =
      exchange.echo_sent.time_since_epoch() - exchange.echo_received.time_since_epoch();
  if (exchanges_.is_full()) exchanges_.erase(0);
  exchanges_.push_back({exchange.echo_received, out / 2 + back / 2, trip / 2});
  return true;
}

Duration ClockOffset::sigma_of(const Sample& sample, HostTime now) const {
  // Uniform within half a round trip, and a drift of unknown sign since then.
  const double trip = to_seconds(sample.half_trip) / std::numbers::sqrt3;
  const double drift = parameters_.max_drift * std::abs(to_seconds(now - sample.time));
  const double least = to_seconds(parameters_.smallest_sigma);
  return from_seconds(std::sqrt(trip * trip + drift * drift + least * least));
}

std::optional<ClockEstimate> ClockOffset::at(HostTime now) const {
  std::optional<ClockEstimate> best;
  for (const Sample& sample : exchanges_) {
    if (now - sample.time > parameters_.window) continue;
    const Duration sigma = sigma_of(sample, now);
    if (!best || sigma < best->sigma) best = ClockEstimate{sample.offset, sigma};
  }
  return best;
}

}  // namespace teamsight::fusion
