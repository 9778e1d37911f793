// recording/proto_values.hpp: protobuf parts back into values. For recording/ only.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include <Eigen/Core>
#include <google/protobuf/stubs/logging.h>

#include "bus/fault.hpp"
#include "bus/messages.hpp"
#include "geometry/frames.hpp"
#include "geometry/identity.hpp"
#include "geometry/pose.hpp"
#include "geometry/sighting.hpp"
#include "geometry/time.hpp"
#include "recording/proto_of.hpp"

namespace teamsight::recording::parts {

/// Converts and remembers whether anything did not fit its type.
class Decoding {
 public:
  [[nodiscard]] bool is_good() const { return is_good_; }

  template <class Integer>
  [[nodiscard]] Integer narrow(std::uint64_t value) {
    if (value > std::numeric_limits<Integer>::max()) is_good_ = false;
    return static_cast<Integer>(value);
  }

  /// An enum whose values go from 0 to `last`.
  template <class Enum>
  [[nodiscard]] Enum code(std::int64_t value, Enum last) {
    if (value < 0 || value > static_cast<std::int64_t>(last)) {
      is_good_ = false;
      return {};
    }
    return static_cast<Enum>(value);
  }

  /// Nearest nanosecond; ten years at most.
  [[nodiscard]] Duration from_ms(double milliseconds) {
    if (!(std::abs(milliseconds) < kLargestMs)) {
      is_good_ = false;
      return {};
    }
    return Duration{std::llround(milliseconds * 1e6)};
  }

  [[nodiscard]] ObservationId id(const v1::SampleId& from) {
    return {narrow<RobotId>(from.robot_id()), from.boot_id(), from.sequence_number()};
  }

  /// The upper triangle, row by row.
  template <int Size>
  [[nodiscard]] Eigen::Matrix<double, Size, Size> cov(
      const google::protobuf::RepeatedField<double>& from) {
    Eigen::Matrix<double, Size, Size> to = Eigen::Matrix<double, Size, Size>::Identity();
    if (from.size() != Size * (Size + 1) / 2) {
      is_good_ = false;
      return to;
    }
    int next = 0;
    for (int row = 0; row < Size; ++row) {
      for (int column = row; column < Size; ++column) {
        to(row, column) = to(column, row) = from.Get(next++);
      }
    }
    return to;
  }

  /// Angles outside of (-pi, pi] and what is not finite are refused: a pose would wrap them.
  template <class From>
  [[nodiscard]] Pose<Field, Robot> pose(const From& from) {
    require(std::abs(from.theta_rad()) < kLargestAngle);
    if (!is_good_) return {};
    return {from.x_m(), from.y_m(), from.theta_rad()};
  }

  [[nodiscard]] PostureEstimate posture(const v1::PostureReport& from) {
    PostureEstimate to;
    to.status = code(from.status(), PostureStatus::kOk);
    to.X_FR = pose(from.posture());
    to.cov = cov<3>(from.posture().cov());
    to.half_log_odds = from.half_log_odds();
    to.inlier_ratio = from.inlier_ratio();
    to.line_points = narrow<std::uint16_t>(from.line_points());
    return to;
  }

  void require(bool holds) { is_good_ = is_good_ && holds; }

 private:
  static constexpr double kLargestMs = 3.2e11;
  static constexpr double kLargestAngle = 3.1416;

  bool is_good_{true};
};

[[nodiscard]] inline PeerTime stamp(std::int64_t nanoseconds) {
  return PeerTime{Duration{nanoseconds}};
}

template <class Frame>
void set(const v1::Vector3& from, Point3<Frame>& to) {
  to = {from.x(), from.y(), from.z()};
}

template <class Frame>
void set(const v1::Vector3& from, Velocity3<Frame>& to) {
  to = {from.x(), from.y(), from.z()};
}

/// Parses, converts with `value(proto, decoding)` and checks.
template <class Message, class Value>
[[nodiscard]] std::optional<Message> decode(std::string_view payload, const Value& value) {
  typename ProtoOf<Message>::Type proto;
  const google::protobuf::LogSilencer quiet;  // it would print a line for each bad payload
  if (!proto.ParseFromArray(payload.data(), static_cast<int>(payload.size()))) return std::nullopt;
  Decoding decoding;
  Message message = value(proto, decoding);
  if (!decoding.is_good() || bus::fault_of(message)) return std::nullopt;
  return message;
}

}  // namespace teamsight::recording::parts
