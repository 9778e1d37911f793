// recording/from_proto.hpp: recorded protobuf messages back into the values they were made from.
#pragma once

#include <optional>
#include <string_view>

#include "bus/messages.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::recording {

/// The value in a recorded payload: the exact inverse of `to_proto` and serialising.
///
/// Defined for every message of bus/messages.hpp and for WorldModel.
///
/// @return nothing if the bytes are not such a message, or if it breaks a rule of its topic
///         (bus/reject.hpp): what a reader on the bus would have dropped, a recording does not
///         bring back
template <class Message>
[[nodiscard]] std::optional<Message> from_payload(std::string_view payload);

}  // namespace teamsight::recording
