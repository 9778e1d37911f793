// monitor/viewer/protocol.hpp: Foxglove's WebSocket protocol as values: texts in, texts out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "recording/message_sink.hpp"

namespace teamsight::monitor {

/// How loud a status text is to the viewer's user.
enum class StatusLevel : std::uint8_t { kInfo = 0, kWarning = 1, kError = 2 };

/// Which of the subprotocols a client offers is spoken with it ([FoxgloveWs]); both names mean the
/// same on the wire.
///
/// @param offered  the header Sec-WebSocket-Protocol: names with commas between
/// @return the first that we know; empty: it is no viewer
[[nodiscard]] std::string_view viewer_protocol(std::string_view offered);

/// The first text of a connection.
///
/// @param session  differs for each start of the station
[[nodiscard]] std::string viewer_greeting(std::string_view name, std::string_view session);

/// Tells of channels; `first` is the number of the first of them.
[[nodiscard]] std::string viewer_advertisement(recording::ChannelId first,
                                               const std::vector<recording::Channel>& channels);

[[nodiscard]] std::string viewer_status(StatusLevel level, std::string_view text);

/// What stands before the payload of a message.
using ViewerHeader = std::array<char, 13>;
[[nodiscard]] ViewerHeader viewer_header(std::uint32_t subscription, std::int64_t log_ns);

/// Which channels one viewer has asked for, under which numbers of its own.
class Subscriptions {
 public:
  /// Takes one text of the viewer: a JSON object with "op". Whatever else it may be is answered
  /// and changes nothing; of a list, what can be done is done.
  ///
  /// @param channels  that there are
  /// @return the status text to answer with; empty: nothing is to be said
  [[nodiscard]] std::string hear(std::string_view text, std::size_t channels);

  /// By the viewer's number.
  [[nodiscard]] const std::map<std::uint32_t, recording::ChannelId>& all() const { return all_; }

 private:
  std::map<std::uint32_t, recording::ChannelId> all_;
};

/// More subscriptions of one viewer than this are refused.
inline constexpr std::size_t kMaxSubscriptions = 256;

}  // namespace teamsight::monitor
