// monitor/referee/box_link.hpp: the TCP connection to the referee box; comes back by itself.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "bus/loop.hpp"
#include "geometry/time.hpp"
#include "monitor/referee/box_protocol.hpp"

namespace teamsight::monitor {

struct BoxAddress {
  std::string host;  ///< an IP address
  std::uint16_t port{28097};
};

/// Never waits: a box that is away, silent or does not read costs nothing but its own messages.
/// Use from the loop's thread.
class BoxLink {
 public:
  struct Listener {
    std::function<void(std::string_view)> message;
    std::function<void(bool is_connected)> connection;
  };

  /// @throws std::runtime_error if the host is no IP address
  BoxLink(BoxAddress address, bus::Loop& loop, Listener listener);
  ~BoxLink();
  BoxLink(const BoxLink&) = delete;
  BoxLink& operator=(const BoxLink&) = delete;

  /// Sends `message` with its NUL. While an earlier one is still on its way the newest waits.
  void send(std::string message);

  [[nodiscard]] bool is_connected() const { return state_ == State::kConnected; }

  /// Messages that were handed over whole to the system since the connection began.
  [[nodiscard]] std::uint64_t sent() const { return sent_; }

  /// Messages replaced by newer ones because the box did not read.
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }

 private:
  enum class State : std::uint8_t { kIdle, kConnecting, kConnected };

  void tick();
  void connect();
  void finish_connecting();
  void read();
  void write();
  void close();

  BoxAddress address_;
  bus::Loop* loop_;
  Listener listener_;
  NulFramer framer_;
  State state_{State::kIdle};
  int socket_{-1};
  HostTime tried_{};
  std::string outgoing_;  ///< rest of the message that is being sent
  std::string next_;
  std::uint64_t sent_{0};
  std::uint64_t skipped_{0};
};

}  // namespace teamsight::monitor
