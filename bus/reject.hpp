// bus/reject.hpp: why a sample from outside was dropped.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace teamsight::bus {

/// Every reason for which a received sample is dropped; it is never repaired.
enum class Reject : std::uint8_t {
  kNotFinite,          ///< a NaN or an infinity
  kBadCovariance,      ///< not positive definite, or absurdly small or large
  kBadIdentity,        ///< robot id out of range, boot or sequence 0, key and id differ
  kBadEnum,            ///< a value no version-1 writer sends
  kOutOfRange,         ///< a number that cannot be: a robot 1 km away, a ratio of 3
  kUnbounded,          ///< a sequence or string longer than its bound, or not terminated
  kDuplicate,          ///< the same id as the last one, or an older one, of the same boot
  kForeignIdentity,    ///< said by one speaker in another's name (only noticed with security on)
  kImplausibleStamp,   ///< far from what this writer's stamps were up to now, or negative
  kImplausibleNumber,  ///< a sequence number further ahead than anybody can have counted
};

inline constexpr std::size_t kRejectReasons = 10;

/// The name used in counters and logs, e.g. "bad_covariance".
[[nodiscard]] std::string_view to_string(Reject reason) noexcept;

/// How many samples were taken, and how many were dropped for which reason.
struct ReadCounters {
  std::uint64_t accepted{0};
  std::uint64_t lost{0};  ///< gaps in the sequence numbers of the accepted ones
  std::array<std::uint64_t, kRejectReasons> rejected{};

  [[nodiscard]] std::uint64_t total_rejected() const noexcept;
};

}  // namespace teamsight::bus
