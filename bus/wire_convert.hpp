// bus/wire_convert.hpp: parts of messages to parts of wire types and back. For bus/ only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Core>
#include <teamsight.h>

#include "bus/reject.hpp"
#include "geometry/identity.hpp"
#include "geometry/sighting.hpp"
#include "geometry/time.hpp"

namespace teamsight::bus {

// ---- to the wire; a value that its field cannot hold is noted in an Encoding -------------------

/// Converts numbers whose wire type is narrower, and remembers the first that did not fit.
class Encoding {
 public:
  /// A probability; 0.5 % steps are lost.
  std::uint8_t percent(double share) noexcept;

  /// Not negative; beyond 65.5 s it says 65535.
  std::uint16_t age_ms(Duration age) noexcept;

  /// Not negative; saturates like age_ms.
  std::uint32_t long_ms(Duration age) noexcept;

  /// Whole steps of `step` metres, e.g. 0.001, if they fit 16 bits with or without sign.
  std::uint16_t unsigned_steps(double metres, double step) noexcept;
  std::int16_t signed_steps(double metres, double step) noexcept;

  /// Copies with an end; too long is an error, never cut.
  void text(const std::string& from, char* to, std::size_t size) noexcept;

  /// Whether a sequence of `length` fits `bound`.
  [[nodiscard]] bool fits(std::size_t length, std::size_t bound) noexcept;

  [[nodiscard]] const std::optional<Reject>& broken() const noexcept { return broken_; }

 private:
  void refuse(Reject reason) noexcept;

  std::optional<Reject> broken_;
};

[[nodiscard]] inline float single(double value) {
  return static_cast<float>(value);
}

[[nodiscard]] inline std::uint8_t octet(bool value) {
  return value ? std::uint8_t{1} : std::uint8_t{0};
}

[[nodiscard]] inline std::int64_t nanoseconds(PeerTime time) {
  return time.time_since_epoch().count();
}

/// Writes the upper triangle, row by row.
template <int Size>
void write_triangle(const Eigen::Matrix<double, Size, Size>& cov, float* out) {
  for (int row = 0; row < Size; ++row) {
    for (int column = row; column < Size; ++column) *out++ = single(cov(row, column));
  }
}

[[nodiscard]] teamsight_v1_SampleId to_wire(const ObservationId& id);

template <class A, class B>
[[nodiscard]] teamsight_v1_Posture to_wire(const Pose<A, B>& X_AB, const Eigen::Matrix3d& cov) {
  teamsight_v1_Posture wire{};
  wire.x_m = single(X_AB.x());
  wire.y_m = single(X_AB.y());
  wire.theta_rad = single(X_AB.theta());
  write_triangle<3>(cov, wire.cov);
  return wire;
}

[[nodiscard]] teamsight_v1_PostureReport to_wire(const PostureEstimate& estimate);

/// Lends `storage` to the sequence of a wire sample for one write.
template <class Sequence, class Storage>
void lend(Storage& storage, std::size_t length, Sequence& sequence) {
  sequence._buffer = storage.data();
  sequence._length = static_cast<std::uint32_t>(length);
  sequence._maximum = static_cast<std::uint32_t>(storage.size());
  sequence._release = false;
}

// ---- from the wire; everything was checked before ----------------------------------------------

template <int Size>
[[nodiscard]] Eigen::Matrix<double, Size, Size> symmetric(const float* triangle) {
  Eigen::Matrix<double, Size, Size> cov;
  for (int i = 0; i < Size; ++i) {
    for (int j = i; j < Size; ++j) cov(i, j) = cov(j, i) = static_cast<double>(*triangle++);
  }
  return cov;
}

[[nodiscard]] inline double share(std::uint8_t percent) {
  return static_cast<double>(percent) / 100.0;
}

[[nodiscard]] inline PeerTime peer_time(std::int64_t nanoseconds) {
  return PeerTime{Duration{nanoseconds}};
}

[[nodiscard]] inline Duration milliseconds(std::uint32_t count) {
  return std::chrono::milliseconds(count);
}

[[nodiscard]] ObservationId from_wire(const teamsight_v1_SampleId& wire);

[[nodiscard]] Pose<Field, Robot> pose_from_wire(const teamsight_v1_Posture& wire);

[[nodiscard]] PostureEstimate from_wire(const teamsight_v1_PostureReport& wire);

}  // namespace teamsight::bus
