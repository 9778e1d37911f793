// bus/topics.hpp: the one table of all topics: name and quality of service. Why these:
// idl/README.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "bus/messages.hpp"

namespace teamsight::bus {

/// The two ways a topic travels.
enum class Delivery : std::uint8_t {
  kState,  ///< best effort, volatile: the next sample replaces a lost one
  kEvent,  ///< reliable, transient local: every sample counts, also for who joins late
};

/// How one topic is written and read. Both ends always use the same row.
struct TopicProfile {
  std::string_view topic;  ///< on the wire, with the version of its type
  Delivery delivery{Delivery::kState};
  std::int32_t keep_last{1};  ///< samples per instance, in the reader and for who joins late
  bool leased{false};  ///< silence for the network's lease counts as gone; else only with the host
  Duration lifespan{0};   ///< older samples are not handed out any more; 0 = never too old
  bool exclusive{false};  ///< only the strongest live writer is heard
};

/// How long the writer of a leased topic may be silent, unless the network's profile says
/// otherwise: five frames at 25 Hz; fewer flap under load.
inline constexpr Duration kDefaultLease = std::chrono::milliseconds(200);

/// How long one write of an event may wait for a slow reader.
inline constexpr Duration kMaxBlocking = std::chrono::milliseconds(50);

/// The row of one message; defined for every message of bus/messages.hpp and for WorldModel.
template <class Message>
[[nodiscard]] const TopicProfile& topic_profile() noexcept;

inline constexpr std::size_t kTopics = 14;

/// All rows, for tools and tests.
[[nodiscard]] const std::array<TopicProfile, kTopics>& all_topics() noexcept;

}  // namespace teamsight::bus
