// bus/reader.hpp: taking validated values from a topic.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "bus/computer.hpp"
#include "bus/messages.hpp"
#include "bus/participant.hpp"
#include "bus/reject.hpp"
#include "geometry/time.hpp"

namespace teamsight::bus {

/// Whether somebody still writes this instance.
enum class Presence : std::uint8_t {
  kAlive,
  kSilent,  ///< its last writer's lease ended or it left without a word
  kGone,    ///< disposed
};

/// One step of one instance: a new value, or a change of presence, or both.
template <class Message>
struct Sample {
  std::optional<Message> message;  ///< nothing: only the presence changed
  Presence presence{Presence::kAlive};
  std::uint64_t instance{0};  ///< tells instances apart while the reader lives
  std::uint64_t writer{0};    ///< tells writers apart while they live
  HostTime received;          ///< when it was taken
};

/// What a writer is called on the network: its GUID. It keeps it for as long as it lives.
using WriterName = std::array<std::uint8_t, 16>;

/// Reads one topic. Samples that fail validation are dropped and counted. Use from one thread.
///
/// Defined for every message of bus/messages.hpp and for WorldModel.
template <class Message>
class Reader {
 public:
  explicit Reader(const Participant& participant);
  Reader(Reader&&) noexcept;
  Reader& operator=(Reader&&) noexcept;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader();

  /// Calls `use` for each sample that has arrived since the last call: of each key the oldest
  /// first, and events in the order in which their writer wrote them, up to 32 at a time.
  ///
  /// @param now  stamped on every sample
  /// @return how many samples were handed over
  std::size_t take(HostTime now, const std::function<void(const Sample<Message>&)>& use);

  /// Readable (poll, epoll) whenever there is something to take; cleared by `take`.
  [[nodiscard]] int event_fd() const noexcept;

  /// How many writers of this topic are alive now.
  [[nodiscard]] std::uint32_t live_writers() const noexcept;

  /// The writers that live, and yet nothing of theirs came within `patience`.
  ///
  /// A writer's lease is renewed by what arrives from it, before the library judges its sequence
  /// number. One that lives and is not heard has been shut out by a number higher than its own,
  /// and only a new participant at one of the two ends ends that. A writer that has just begun is
  /// among them until its first sample comes. On a topic of exclusive ownership it is all or none
  /// of them, as the weaker ones are never heard.
  [[nodiscard]] std::vector<WriterName> unheard_writers(HostTime now, Duration patience) const;

  /// The writers of whom something new came within `patience`, whether they live or not.
  [[nodiscard]] std::vector<WriterName> heard_writers(HostTime now, Duration patience) const;

  /// The computer that a writer's process runs on; empty of name and address if it is not known.
  ///
  /// @param writer  of a sample
  [[nodiscard]] Computer computer_of(std::uint64_t writer) const;

  /// When last a process that was heard before was heard through a new writer: it has joined anew.
  /// Zero: never.
  [[nodiscard]] HostTime writer_renamed() const noexcept;

  [[nodiscard]] const ReadCounters& counters() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight::bus
