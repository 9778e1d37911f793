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
/// must have moved as much as the receiver's clock, give or take kLargestSkew. After
/// kSamplesToRelearn such samples in a row the past is taken to be wrong and starts anew (a
/// computer that was asleep). A new boot has no past. Remembers kWriters pasts, the latest used
/// ones.
class History {
 public:
  static constexpr Duration kLargestSkew = std::chrono::seconds(2);
  static constexpr std::uint32_t kSamplesToRelearn = 20;
  static constexpr std::size_t kWriters = 64;

  History();

  /// @param stamp     of the sample; nothing = its stamps are not judged
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
    std::uint64_t used{0};
  };

  [[nodiscard]] static bool is_plausible(const Past& past, PeerTime stamp, HostTime received);
  Past* find(std::uint64_t instance, const ObservationId& id);
  Past& remember_new();

  std::vector<Past> pasts_;
  std::uint64_t clock_{0};
};

}  // namespace teamsight::bus
