// bus/wire_convert.cpp: parts of messages to parts of wire types and back.
#include "bus/wire_convert.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace teamsight::bus {

void Encoding::refuse(Reject reason) noexcept {
  if (!broken_) broken_ = reason;
}

std::uint8_t Encoding::percent(double share) noexcept {
  if (!(share >= 0.0 && share <= 1.0)) {
    refuse(std::isfinite(share) ? Reject::kOutOfRange : Reject::kNotFinite);
    return 0;
  }
  return static_cast<std::uint8_t>(std::lround(share * 100.0));
}

std::uint16_t Encoding::age_ms(Duration age) noexcept {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint16_t>::max();
  return static_cast<std::uint16_t>(std::min(long_ms(age), kMost));
}

std::uint32_t Encoding::long_ms(Duration age) noexcept {
  constexpr std::int64_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (age < Duration{0}) refuse(Reject::kOutOfRange);
  const std::int64_t count = (age.count() / 1'000'000) + ((age.count() % 1'000'000) >= 500'000);
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(count, 0, kMost));
}

std::uint16_t Encoding::unsigned_steps(double metres, double step) noexcept {
  const double steps = std::round(metres / step);
  if (steps >= 0.0 && steps <= std::numeric_limits<std::uint16_t>::max()) {
    return static_cast<std::uint16_t>(steps);
  }
  refuse(std::isfinite(steps) ? Reject::kOutOfRange : Reject::kNotFinite);
  return 0;
}

std::int16_t Encoding::signed_steps(double metres, double step) noexcept {
  const double steps = std::round(metres / step);
  if (std::abs(steps) <= std::numeric_limits<std::int16_t>::max()) {
    return static_cast<std::int16_t>(steps);
  }
  refuse(std::isfinite(steps) ? Reject::kOutOfRange : Reject::kNotFinite);
  return 0;
}

void Encoding::text(const std::string& from, char* to, std::size_t size) noexcept {
  // A zero inside would arrive as a shorter text.
  const bool whole = from.size() < size && from.find('\0') == std::string::npos;
  if (!whole) refuse(Reject::kUnbounded);
  std::memset(to, 0, size);
  if (whole) from.copy(to, from.size());
}

bool Encoding::fits(std::size_t length, std::size_t bound) noexcept {
  if (length > bound) refuse(Reject::kUnbounded);
  return length <= bound;
}

teamsight_v1_SampleId to_wire(const ObservationId& id) {
  return {id.robot, id.boot, id.sequence};
}

teamsight_v1_PostureReport to_wire(const PostureEstimate& estimate) {
  teamsight_v1_PostureReport wire{};
  wire.status = static_cast<teamsight_v1_PostureStatus>(estimate.status);
  wire.posture = to_wire(estimate.X_FR, estimate.cov);
  wire.half_log_odds = single(estimate.half_log_odds);
  wire.inlier_ratio = single(estimate.inlier_ratio);
  wire.line_points = estimate.line_points;
  return wire;
}

ObservationId from_wire(const teamsight_v1_SampleId& wire) {
  return {wire.robot_id, wire.boot_id, wire.sequence_number};
}

Pose<Field, Robot> pose_from_wire(const teamsight_v1_Posture& wire) {
  return {static_cast<double>(wire.x_m),
          static_cast<double>(wire.y_m),
          static_cast<double>(wire.theta_rad)};
}

PostureEstimate from_wire(const teamsight_v1_PostureReport& wire) {
  PostureEstimate estimate;
  estimate.status = static_cast<PostureStatus>(wire.status);
  estimate.X_FR = pose_from_wire(wire.posture);
  estimate.cov = symmetric<3>(wire.posture.cov);
  estimate.half_log_odds = static_cast<double>(wire.half_log_odds);
  estimate.inlier_ratio = static_cast<double>(wire.inlier_ratio);
  estimate.line_points = wire.line_points;
  return estimate;
}

}  // namespace teamsight::bus
