// bus/heard_writers.hpp: which writers of a topic a reader has heard of late. For bus/ only.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/identity.hpp"
#include "geometry/time.hpp"

namespace teamsight::bus {

/// A value. Remembers kMost writers, the latest ones.
class HeardWriters {
 public:
  static constexpr std::size_t kMost = 64;

  HeardWriters();

  /// A sample came from this writer, made by this one, and was good or, if `repeated`, only what
  /// had come before.
  void note(std::uint64_t writer, const ObservationId& maker, bool repeated, HostTime now);

  /// When a process that was heard before was first heard through another writer; zero: never.
  [[nodiscard]] HostTime renamed() const { return renamed_; }

  /// The own participant is a new one: so are the writers' handles.
  void forget_writers() { entries_.clear(); }

  /// Whether the writer can be heard: within `patience` it said something new, or repeated what
  /// another one says in the same name (an echo of a session that is over).
  [[nodiscard]] bool has(std::uint64_t writer, HostTime now, Duration patience) const;

 private:
  struct Entry {
    std::uint64_t writer{0};
    RobotId robot{kNobody};
    std::uint32_t boot{0};
    HostTime news;
    HostTime any;
  };

  std::vector<Entry>::iterator make_room();

  std::vector<Entry> entries_;
  HostTime renamed_{};
};

}  // namespace teamsight::bus
