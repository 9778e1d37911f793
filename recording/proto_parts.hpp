// recording/proto_parts.hpp: the small parts that several messages of to_proto share.
#pragma once

#include <Eigen/Core>

#include "bus/messages.hpp"
#include "geometry/frames.hpp"
#include "geometry/pose.hpp"
#include "geometry/sighting.hpp"
#include "recording.pb.h"

namespace teamsight::recording::parts {

/// Milliseconds as a double, the unit of every duration on the page.
[[nodiscard]] inline double to_ms(Duration duration) {
  return static_cast<double>(duration.count()) / 1e6;
}

[[nodiscard]] inline std::int64_t to_ns(PeerTime stamp) {
  return stamp.time_since_epoch().count();
}

inline void set(const ObservationId& from, v1::SampleId& to) {
  to.set_robot_id(from.robot);
  to.set_boot_id(from.boot);
  to.set_sequence_number(from.sequence);
}

template <class Frame>
void set(const Point3<Frame>& from, v1::Vector3& to) {
  to.set_x(from.x);
  to.set_y(from.y);
  to.set_z(from.z);
}

template <class Frame>
void set(const Velocity3<Frame>& from, v1::Vector3& to) {
  to.set_x(from.x);
  to.set_y(from.y);
  to.set_z(from.z);
}

/// The upper triangle, row by row, as in idl/teamsight.idl.
template <int Size>
void add_upper(const Eigen::Matrix<double, Size, Size>& cov,
               google::protobuf::RepeatedField<double>& to) {
  for (int row = 0; row < Size; ++row) {
    for (int column = row; column < Size; ++column) to.Add(cov(row, column));
  }
}

inline void set(const Pose<Field, Robot>& X_FR, const Eigen::Matrix3d& cov, v1::Posture& to) {
  to.set_x_m(X_FR.x());
  to.set_y_m(X_FR.y());
  to.set_theta_rad(X_FR.theta());
  add_upper(cov, *to.mutable_cov());
}

inline void set(const PostureEstimate& from, v1::PostureReport& to) {
  to.set_status(static_cast<v1::PostureStatus>(from.status));
  set(from.X_FR, from.cov, *to.mutable_posture());
  to.set_half_log_odds(from.half_log_odds);
  to.set_inlier_ratio(from.inlier_ratio);
  to.set_line_points(from.line_points);
}

inline void set(const bus::Counter& from, v1::Counter& to) {
  to.set_name(from.name);
  to.set_value(from.value);
}

inline void set(const bus::ExplainedRobot& from, v1::ExplainedRobot& to) {
  to.set_robot_id(from.robot);
  to.set_trust(from.trust);
  to.set_quarantine(static_cast<std::uint32_t>(from.quarantine));
  to.set_accepted(from.accepted);
  to.set_rejected_gate(from.rejected_gate);
  to.set_rejected_late(from.rejected_late);
  to.set_rejected_duplicate(from.rejected_duplicate);
  to.set_rejected_posture(from.rejected_posture);
  to.set_clock_offset_ms(to_ms(from.clock_offset));
  to.set_clock_sigma_ms(to_ms(from.clock_sigma));
}

}  // namespace teamsight::recording::parts
