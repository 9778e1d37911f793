// process/rejoin_rule.hpp: when to join the bus anew since somebody lives and is not heard. A
// value; time as an argument.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "bus/reader.hpp"
#include "geometry/time.hpp"

namespace teamsight::process {

/// Why somebody is taken to live and yet not to be heard, or not to hear.
enum class Sign : std::uint8_t {
  kLeased,    ///< its topic's lease holds
  kBeside,    ///< on a topic without lease, of which is told seldom; it is heard on another one
  kDoubtful,  ///< the same, heard nowhere, and yet its computer says it is there: shut out or hung
  kUnanswered,  ///< it is heard, and has not done what this process asked of it
};

/// A writer that lives and was not heard of late; of `kUnanswered`, the robot's.
struct Unheard {
  bus::WriterName name{};
  Sign sign{Sign::kLeased};
};

struct RejoinParameters {
  Duration patience{std::chrono::seconds(2)};  ///< unheard without a break before it counts
  /// The same on a quiet topic. With diagnostics a third as often (every 3 s) and 30 % loss, ten in
  /// a row are lost by chance once in 170,000 times.
  Duration quiet_patience{std::chrono::seconds(30)};
  Duration pause{std::chrono::seconds(5)};  ///< between two times, at least
  /// One writer is a reason once in so long: what joining anew has not helped, it will not help at
  /// once (somebody goes on forging, or repeats a session that is over). A doubtful one is a reason
  /// once until it is heard: a process that hangs must not make the team join anew every minute.
  Duration memory{std::chrono::seconds(60)};
  /// Whoever has not joined anew for so long does it when another one does: the forger knows this
  /// one's old name as well, and it cannot notice itself that nobody hears it.
  Duration follow{std::chrono::seconds(30)};
  Duration longest_step{std::chrono::seconds(1)};  ///< after a longer one nothing was watched
};

/// Bounded: at most once per `pause`, and per writer at most once per `memory`.
class RejoinRule {
 public:
  explicit RejoinRule(const RejoinParameters& parameters) : parameters_(parameters) {}

  /// To be called a few times a second.
  ///
  /// @param unheard  every writer that lives and was not heard of late
  /// @param peer     when last another process joined anew; zero: never
  /// @return whether to join anew now; it is taken to be done
  [[nodiscard]] bool step(const std::vector<Unheard>& unheard, HostTime peer, HostTime now);

 private:
  [[nodiscard]] bool has_reason(HostTime peer, HostTime now) const;

  RejoinParameters parameters_;

  struct Silence {
    HostTime since;  // without a break
    Sign sign{Sign::kLeased};
  };

  [[nodiscard]] Duration patience_with(Sign sign) const;
  [[nodiscard]] bool is_doubtful(const bus::WriterName& name) const;

  std::map<bus::WriterName, Silence> silent_;
  std::map<bus::WriterName, HostTime> blamed_;  // when last
  HostTime stepped_{};
  std::optional<HostTime> rejoined_;
};

}  // namespace teamsight::process
