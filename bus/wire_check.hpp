// bus/wire_check.hpp: the rules that several wire types share. For bus/ only.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include <teamsight.h>

#include "bus/reject.hpp"

namespace teamsight::bus {

// Limits of what can be at all; far outside of any field, so that nothing honest is refused.
inline constexpr double kLargestDistance = 100.0;  // m
inline constexpr double kLargestSpeed = 100.0;     // m/s
inline constexpr double kLargestTurn = 100.0;      // rad/s
inline constexpr double kLargestLogOdds = 10'000.0;
inline constexpr double kLargestAngle = 3.1416;  // rad; pi and the rounding of a float
inline constexpr std::int64_t kLargestStamp = 315'360'000'000'000'000;  // ns, ten years of uptime

/// Collects the first broken rule of one wire sample. Every call states one rule.
class WireCheck {
 public:
  void require(bool holds, Reject otherwise) noexcept {
    if (!holds && !broken_) broken_ = otherwise;
  }

  /// Finite and within [low, high].
  void between(double value, double low, double high) noexcept {
    require(std::isfinite(value), Reject::kNotFinite);
    require(value >= low && value <= high, Reject::kOutOfRange);
  }

  /// Finite and within [-limit, limit].
  void within(double value, double limit) noexcept { between(value, -limit, limit); }

  void share(double value) noexcept { between(value, 0.0, 1.0); }

  void percent(std::uint8_t value) noexcept { require(value <= 100, Reject::kOutOfRange); }

  void flag(std::uint8_t value) noexcept { require(value <= 1, Reject::kBadEnum); }

  void code(std::uint8_t value, std::uint8_t last) noexcept {
    require(value <= last, Reject::kBadEnum);
  }

  /// A generated enum, whose memory may hold any number.
  template <class Enum>
  void enumerator(const Enum& value, std::int32_t last) noexcept {
    static_assert(sizeof(Enum) == sizeof(std::int32_t));
    std::int32_t raw = 0;
    std::memcpy(&raw, &value, sizeof raw);
    require(raw >= 0 && raw <= last, Reject::kBadEnum);
  }

  void stamp(std::int64_t nanoseconds) noexcept {
    require(nanoseconds >= 0 && nanoseconds <= kLargestStamp, Reject::kImplausibleStamp);
  }

  /// Published after the exposure, both plausible.
  void stamps(std::int64_t exposure_ns, std::int64_t publish_ns) noexcept;

  /// Boot and sequence number not 0, the robot 0 (nobody) to 16.
  void sample_id(const teamsight_v1_SampleId& id) noexcept;

  /// As above, and the key is the robot.
  void host_sample(std::uint8_t key, const teamsight_v1_SampleId& id) noexcept;

  /// As above, and the robot is one: 1 to 16.
  void robot_sample(std::uint8_t key, const teamsight_v1_SampleId& id) noexcept;

  /// As sample_id, and the key is the only one there is.
  void team_sample(std::uint8_t key, const teamsight_v1_SampleId& id) noexcept;

  /// Upper triangle, row by row, of a covariance of `size` (2 or 3) numbers.
  void covariance(const float* triangle, int size) noexcept;

  void posture(const teamsight_v1_Posture& posture) noexcept;

  void posture_report(const teamsight_v1_PostureReport& report) noexcept;

  /// Ends within its `size` bytes; clean UTF-8 without control characters.
  void text(const char* characters, std::size_t size) noexcept;

  /// @return whether the elements may be looked at
  template <class Sequence>
  [[nodiscard]] bool sequence(const Sequence& sequence, std::uint32_t bound) noexcept {
    const bool bounded =
        sequence._length <= bound && (sequence._length == 0 || sequence._buffer != nullptr);
    require(bounded, Reject::kUnbounded);
    return bounded;
  }

  [[nodiscard]] const std::optional<Reject>& broken() const noexcept { return broken_; }

 private:
  std::optional<Reject> broken_;
};

}  // namespace teamsight::bus
