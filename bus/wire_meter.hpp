// bus/wire_meter.hpp: what this process puts on the wire, counted where the library hands it to the
// kernel.
#pragma once

#include <cstdint>

namespace teamsight::bus {

struct WireCounters {
  std::uint64_t datagrams{0};
  std::uint64_t bytes{0};  ///< with the headers of UDP, IP and Ethernet, 42 bytes a datagram
};

/// Everything that this process has sent in one DDS domain: samples, repairs, discovery, and every
/// copy where readers get one each. For any thread.
///
/// The executable's own `sendmsg` counts and passes on; so it is zero in sanitizer builds, which
/// put theirs in the same place.
[[nodiscard]] WireCounters wire_counters(std::uint32_t domain_id) noexcept;

}  // namespace teamsight::bus
