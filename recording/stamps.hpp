// recording/stamps.hpp: the stamps inside a message, whatever they are called.
#pragma once

#include "bus/messages.hpp"
#include "geometry/time.hpp"

namespace teamsight::recording {

/// When a message was written, on its writer's clock; zero if it does not say (Command).
template <class Message>
[[nodiscard]] PeerTime written_at(const Message& message) {
  if constexpr (requires { message.published; }) {
    return message.published;
  } else if constexpr (requires { message.exposure; }) {
    return message.exposure;
  } else if constexpr (requires { message.stamp; }) {
    return message.stamp;
  } else if constexpr (requires { message.sent; }) {
    return message.sent;
  } else {
    return {};
  }
}

/// Calls `use` for each stamp in a message.
template <class Message, class Use>
void for_each_stamp(Message& message, const Use& use) {
  if constexpr (requires { message.published; }) use(message.published);
  if constexpr (requires { message.exposure; }) use(message.exposure);
  if constexpr (requires { message.stamp; }) use(message.stamp);
  if constexpr (requires { message.sent; }) use(message.sent);
  if constexpr (requires { message.replies; }) {
    for (auto& reply : message.replies) use(reply.received);
  }
}

}  // namespace teamsight::recording
