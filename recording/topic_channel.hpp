// recording/topic_channel.hpp: a topic as a channel of a recording.
#pragma once

#include <string>

#include "recording/mcap_writer.hpp"

namespace google::protobuf {
class Descriptor;
}

namespace teamsight::recording {

/// A protobuf type as an MCAP schema: its name and all files that it needs.
[[nodiscard]] Schema schema_of(const google::protobuf::Descriptor& type);

/// The channel of one message type; the topic is that of the bus, "teamsight/v1/...".
///
/// Defined for every message of bus/messages.hpp and for WorldModel.
template <class Message>
[[nodiscard]] Channel channel_of();

/// `to_proto`, serialised.
template <class Message>
[[nodiscard]] std::string payload_of(const Message& message);

}  // namespace teamsight::recording
