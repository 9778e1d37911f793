// bus/history.hpp: what is plausible after what was heard before: order, gaps, stamps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "bus/reject.hpp"
#include "geometry/identity.hpp"
#include "geometry/result.hpp"
#include "geometry/time.hpp"

namespace teamsight::bus {

/// The past of one reader's samples, per instance and boot of their writer.
///
/// A sample is a duplicate if its sequence number is not above the last one of the same instance
/// and boot: best effort keeps the order, so that what comes late was sent again. Stamps are on the
/// sender's clock, so only their movement can be judged: since the last accepted sample the stamp
/// must have moved as much as the receiver's clock, give or take kLargestSkew, and its number by no
/// more than kMostPerSecond allows: one forged number would make every true one a duplicate. After
/// kSamplesToRelearn such samples in a row, or as many duplicates in rising order, the past is
/// taken to be wrong and starts anew (a computer that was asleep). A new boot has no past.
/// Remembers kWriters pasts, the latest used ones.
class History {
 public:
  static constexpr Duration kLargestSkew = std::chrono::seconds(2);
  static constexpr std::uint32_t kSamplesToRelearn = 20;
  static constexpr double kMostPerSecond = 500.0;  // nobody samples faster
  static constexpr std::uint32_t kMostAtOnce = 10;
  static constexpr std::size_t kWriters = 64;

  History();

  /// @param stamp     of the sample; nothing = neither stamps nor jumps of the number are judged
  /// @param received  when it was taken, host time
  /// @return how many samples were lost before this one, or why it must be dropped
  [[nodiscard]] Result<std::uint32_t, Reject> judge(std::uint64_t instance,
                                                    const ObservationId& id,
                                                    std::optional<PeerTime> stamp,
                                                    HostTime received);

 private:
  struct Past {
    std::uint64_t instance{0};
    ObservationId last;
    std::optional<PeerTime> stamp;
    HostTime received;
    std::uint32_t implausible{0};
    std::uint32_t rising{0};    // duplicates in a row, each above the one before
    std::uint32_t repeated{0};  // number of the last of them
    std::uint64_t used{0};
  };

  [[nodiscard]] static std::optional<Reject> complaint(Past& past,
                                                       const ObservationId& id,
                                                       std::optional<PeerTime> stamp,
                                                       HostTime received);
  [[nodiscard]] static bool continues(Past& past, const ObservationId& id);
  Past* find(std::uint64_t instance, const ObservationId& id);
  Past& remember_new();

  std::vector<Past> pasts_;
  std::uint64_t clock_{0};
};

}  // namespace teamsight::bus
