// fusion/clock_offset.hpp: how far a peer's clock is ahead of this host's, and how sure that is.
#pragma once

#include <optional>

#include "fusion/inline_list.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// One question and its answer: the two ends of two journeys of a packet.
struct ClockExchange {
  HostTime probe_sent;      ///< here
  PeerTime probe_received;  ///< there
  PeerTime echo_sent;       ///< there
  HostTime echo_received;   ///< here
};

struct ClockEstimate {
  Duration offset{0};  ///< peer's clock minus this host's
  Duration sigma{0};   ///< standard deviation of `offset`
};

struct ClockParameters {
  /// How fast two computers' monotonic clocks may drift apart, s/s; quartz: 50 ppm each.
  double max_drift{1e-4};
  Duration window{std::chrono::seconds(30)};  ///< older exchanges are forgotten
  /// Reading two clocks and crossing two kernels is never better than this.
  Duration smallest_sigma{std::chrono::microseconds(20)};
};

/// Two-way time transfer: the exchange with the shortest round trip bounds the offset best, since
/// the true offset lies within half of it on either side [Cristian89]. A value, one per peer.
class ClockOffset {
 public:
  ClockOffset() = default;

  explicit ClockOffset(const ClockParameters& parameters) : parameters_(parameters) {}

  /// Takes one exchange in.
  ///
  /// @return whether it can be: neither the round trip nor the stay at the peer is negative
  bool add(const ClockExchange& exchange);

  /// @return nothing while there was no exchange within the window before `now`
  [[nodiscard]] std::optional<ClockEstimate> at(HostTime now) const;

  /// The peer was started anew: its clock may be another one.
  void forget() { exchanges_ = {}; }

 private:
  struct Sample {
    HostTime time{};
    Duration offset{0};
    Duration half_trip{0};
  };

  [[nodiscard]] Duration sigma_of(const Sample& sample, HostTime now) const;

  ClockParameters parameters_;
  InlineList<Sample, 32> exchanges_;
};

}  // namespace teamsight::fusion
