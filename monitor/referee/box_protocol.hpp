// monitor/referee/box_protocol.hpp: the league's referee box on a TCP connection, as values.
//
// Source: RoboCup-MSL/RefBox 2.1: JSON texts, each ended by a NUL byte, in both directions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/result.hpp"

namespace teamsight::monitor {

/// Cuts a stream into messages at its NUL bytes, however they were split or glued.
class NulFramer {
 public:
  /// A message longer than this is dropped up to its end; the box does the same.
  static constexpr std::size_t kLongestMessage = 100'000;

  /// Calls `use` for each message that `bytes` completes; empty ones are passed over.
  void take(std::string_view bytes, const std::function<void(std::string_view)>& use);

  /// Forgets what has not ended: a new connection.
  void reset();

  /// Messages dropped because of their length.
  [[nodiscard]] std::uint64_t overlong() const { return overlong_; }

 private:
  std::string open_;
  bool is_overlong_{false};
  std::uint64_t overlong_{0};
};

/// One message from the box.
struct BoxCommand {
  std::string name;          ///< e.g. "KICKOFF"
  std::string target;        ///< multicast address of the team meant; empty: both
  std::optional<int> robot;  ///< only in SUBSTITUTION and IS_ALIVE

  friend bool operator==(const BoxCommand&, const BoxCommand&) = default;
};

/// @return the command, blanks around its name dropped (the box has been seen to send them); else
///         what is wrong with the text
[[nodiscard]] Result<BoxCommand, std::string> parse_box_command(std::string_view json);

}  // namespace teamsight::monitor
