// tools/echo_topic.hpp: listening to one topic by its name and writing it down as JSON lines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bus/participant.hpp"
#include "geometry/time.hpp"

namespace teamsight::tools {

/// What to listen to, and for how long.
struct EchoRequest {
  std::string topic;
  bus::DomainSettings domain;
  std::optional<Duration> duration;    ///< nothing: until SIGINT
  std::optional<std::uint64_t> count;  ///< of messages; nothing: no limit
};

/// Every topic, in alphabetical order.
[[nodiscard]] std::vector<std::string_view> echo_topics();

/// Whether a topic lives in the domain inside one computer rather than between the robots.
[[nodiscard]] bool is_host_topic(std::string_view topic);

/// One line on stdout per sample: {"topic", "presence", "received_ns", "message"}, message null
/// where only the presence changed.
///
/// @return 0 if a message was heard; 1 if not, with the reason on stderr
/// @throws std::runtime_error for an unknown topic; the line lists all of them
[[nodiscard]] int echo(const EchoRequest& request);

}  // namespace teamsight::tools
