// tests/network/hosts.hpp: computers in a box: one network namespace each, wired to one switch.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/network/switch.hpp"

namespace teamsight::network {

/// Owns a file descriptor.
class Descriptor {
 public:
  Descriptor() = default;

  explicit Descriptor(int descriptor) noexcept : descriptor_(descriptor) {}

  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();

  [[nodiscard]] int get() const noexcept { return descriptor_; }

 private:
  int descriptor_{-1};
};

/// Puts this process, and what it starts, before others if it may: what is measured is the
/// network's doing and not that of a busy machine.
void go_first() noexcept;

/// Hosts of one network, each with `lo`, one network card and the address 10.77.0.(10 + index).
///
/// The cards are TAP devices that end in this process, in the switch: nothing is connected to the
/// machine's own network, nothing is left when the process ends, however it ends. Hosts have
/// monotonic clocks that lie an hour apart, as computers have that were not booted together.
class Hosts {
 public:
  /// @param count  1 to 32
  /// @param card   name of the network card on every host, e.g. "wlan0"
  /// @param seed   of everything that the switch draws
  /// @throws std::runtime_error if this machine lets us make no namespaces; see `problem`
  Hosts(std::size_t count, const std::string& card, std::uint64_t seed);

  /// Why this machine cannot make hosts; empty if it can.
  [[nodiscard]] static std::string problem();

  [[nodiscard]] std::size_t count() const noexcept { return namespaces_.size(); }

  [[nodiscard]] Switch& network() noexcept { return *switch_; }

  /// The command that runs `argv` on a host, for ChildProcess. No process stands in between.
  [[nodiscard]] std::vector<std::string> on_host(std::size_t host,
                                                 const std::vector<std::string>& argv) const;

  /// How far the host's monotonic clock is ahead of this process's.
  [[nodiscard]] static std::chrono::nanoseconds clock_ahead(std::size_t host);

  [[nodiscard]] static std::string address(std::size_t host);

 private:
  std::vector<Descriptor> namespaces_;
  std::unique_ptr<Switch> switch_;
};

}  // namespace teamsight::network
