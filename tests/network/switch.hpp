// tests/network/switch.hpp: an Ethernet switch in this process, which can be made to behave badly.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace teamsight::network {

/// What happens to a frame on its way to one receiver. All draws are independent per receiver.
struct Weather {
  double loss{0.0};  ///< probability that a frame is lost
  /// Bursts: with this probability per frame one begins, in which everything is lost ...
  double burst_begins{0.0};
  /// ... until, with this probability per frame, it ends.
  double burst_ends{0.2};
  std::chrono::microseconds delay{0};
  std::chrono::microseconds jitter{0};  ///< added to the delay, uniform in [0, jitter]: reorders
  double duplicated{0.0};               ///< probability that a frame comes twice
  bool drops_multicast{false};          ///< broadcast still passes, or nobody would find anybody
};

/// What went through one port.
struct PortCounters {
  std::uint64_t frames{0};
  std::uint64_t bytes{0};      ///< whole Ethernet frames, without preamble and checksum
  std::uint64_t delivered{0};  ///< frames to this host
  std::uint64_t bytes_delivered{0};
};

/// One writer of a topic as it is named on the wire: participant's prefix and entity id.
using WriterGuid = std::array<std::uint8_t, 16>;

/// Of what each port sent.
using BytesByWriter = std::vector<std::map<WriterGuid, std::uint64_t>>;

/// Learns addresses and forwards; runs on a thread of its own. Its methods are for one other
/// thread.
class Switch {
 public:
  /// @param taps  descriptors of TAP devices, one per port; owned from here on
  Switch(std::vector<int> taps, std::uint64_t seed);
  ~Switch();
  Switch(const Switch&) = delete;
  Switch& operator=(const Switch&) = delete;

  void set_weather(const Weather& weather);

  /// Ports reach each other if their groups are equal. At first all are in group 0.
  void set_groups(const std::vector<int>& groups);

  /// Nothing goes in or out there, while the host notices nothing.
  void cut(std::size_t port, bool is_cut);

  [[nodiscard]] PortCounters counters(std::size_t port) const;

  /// Bytes of whole frames by the writer that each RTPS submessage in them names; shares of the
  /// headers in equal parts. What names no writer of data stands under all zeros.
  [[nodiscard]] BytesByWriter bytes_by_writer() const;

  /// Frames as they come in are handed to `onlooker` as well, on the switch's thread; null ends
  /// that.
  void mirror(std::function<void(const std::uint8_t* frame, std::size_t size)> onlooker);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight::network
