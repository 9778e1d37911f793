// bus/writer.hpp: putting values on a topic.
#pragma once

#include <cstdint>
#include <memory>

#include "bus/messages.hpp"
#include "bus/participant.hpp"

namespace teamsight::bus {

/// What became of one write.
enum class WriteStatus : std::uint8_t {
  kWritten,
  kInvalid,   ///< the value breaks the topic's rules; nothing was sent
  kTimedOut,  ///< a reliable reader did not keep up; nothing was sent
  kFailed,
};

struct WriteCounters {
  std::uint64_t written{0};
  std::uint64_t invalid{0};
  std::uint64_t failed{0};  ///< timed out or failed
};

/// Writes one topic. Never throws after construction. Use from one thread.
template <class Message>
class Writer {
 public:
  /// @param ownership_strength  for topics of exclusive ownership (WorldModel): the strongest
  ///                            live writer is the one that readers hear; others ignore it
  explicit Writer(const Participant& participant, std::int32_t ownership_strength = 0);
  Writer(Writer&&) noexcept;
  Writer& operator=(Writer&&) noexcept;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer();

  WriteStatus write(const Message& message) noexcept;

  /// How many readers are matched now.
  [[nodiscard]] std::uint32_t live_readers() const noexcept;

  [[nodiscard]] const WriteCounters& counters() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight::bus
