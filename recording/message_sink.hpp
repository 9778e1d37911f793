// recording/message_sink.hpp: where messages of channels go: files, and viewers that watch live.
#pragma once

#include <cstddef>
#include <string>

#include "geometry/time.hpp"
#include "recording/mcap_writer.hpp"

namespace teamsight::recording {

/// The channel's number in one sink.
using ChannelId = std::size_t;

/// Takes messages and never holds up the caller. Use from one thread.
class MessageSink {
 public:
  MessageSink() = default;
  virtual ~MessageSink() = default;
  MessageSink(const MessageSink&) = delete;
  MessageSink& operator=(const MessageSink&) = delete;

  /// @return the numbers are 0, 1, 2, ... in the order of the calls
  virtual ChannelId add_channel(Channel channel) = 0;

  /// Whether anybody would read it now; what nobody wants need not be made.
  [[nodiscard]] virtual bool is_wanted(ChannelId channel) const = 0;

  /// @param received  when it arrived here
  /// @param stamp     the writer's own
  virtual void write(ChannelId channel, HostTime received, PeerTime stamp, std::string payload) = 0;

  /// What to add to host time to get the time that messages are filed under.
  [[nodiscard]] virtual Duration log_minus_host() const = 0;
};

}  // namespace teamsight::recording
