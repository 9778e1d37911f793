// fusion/teammate.cpp: see fusion/teammate.hpp.
#include "fusion/teammate.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "geometry/angle.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::fusion {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Eigen::Vector3d acceleration_psd(const TeammateParameters& parameters) {
  return {parameters.acceleration_psd,
          parameters.acceleration_psd,
          parameters.angular_acceleration_psd};
}

void start(PostureTrack& track,
           const PostureEstimate& posture,
           HostTime exposure,
           const TeammateParameters& parameters) {
  const double v = parameters.sigma_speed_at_start;
  const double w = parameters.sigma_omega_at_start;
  track.mean << posture.X_FR.vector(), Eigen::Vector3d::Zero();
  track.cov.setZero();
  track.cov.topLeftCorner<3, 3>() = posture.cov;
  track.cov.bottomRightCorner<3, 3>().diagonal() << v * v, v * v, w * w;
  track.last = posture;
  track.time = exposure;
}

void predict(PostureTrack& track, double dt, const TeammateParameters& parameters) {
  Matrix6 transition = Matrix6::Identity();
  transition.topRightCorner<3, 3>() = dt * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d psd = acceleration_psd(parameters).asDiagonal();
  Matrix6 disturbance;
  disturbance << psd * (dt * dt * dt / 3.0), psd * (dt * dt / 2.0), psd * (dt * dt / 2.0), psd * dt;
  track.mean = transition * track.mean;
  track.cov = transition * track.cov * transition.transpose() + disturbance;
}

/// Variances of what the lasting part of a posture's error changes by in `dt`: it fades, and a
/// robot that has become surer has corrected itself by so much.
Eigen::Vector3d drift_of(const PostureEstimate& last,
                         const PostureReport& report,
                         double dt,
                         const TeammateParameters& parameters) {
  const Eigen::Matrix3d& cov = report.posture.cov;
  const double forgotten = -std::expm1(-2.0 * dt / to_seconds(parameters.posture_memory));
  return forgotten * (cov - report.cov_shake).diagonal().cwiseMax(0.0) +
         (last.cov - cov).diagonal().cwiseMax(0.0);
}

PostureStep kind_of_jump(const Eigen::Vector3d& expected,
                         const Pose<Field, Robot>& found,
                         double far) {
  const Pose<Field, Robot> other = mirrored({expected.x(), expected.y(), expected.z()});
  const auto distance = [&](const Eigen::Vector2d& p_F) {
    return (found.origin().vector() - p_F).norm();
  };
  constexpr double kSameHeading = 0.7;  // rad
  const bool is_turned = std::abs(angle_difference(found.theta(), other.theta())) < kSameHeading;
  if (is_turned && distance(other.origin().vector()) < 1.0) return PostureStep::kTurnedOver;
  return distance(expected.head<2>()) < far ? PostureStep::kSmallJump : PostureStep::kJump;
}

}  // namespace

PostureStep take_posture(PostureTrack& track,
                         const PostureReport& report,
                         const TeammateParameters& parameters,
                         double far) {
  const PostureEstimate& posture = report.posture;
  if (track.time == kNever) {
    start(track, posture, report.exposure, parameters);
    return PostureStep::kSmallJump;
  }
  PostureTrack next = track;
  const double dt = std::max(0.0, to_seconds(report.exposure - track.time));
  predict(next, dt, parameters);
  next.cov.diagonal().head<3>() += drift_of(track.last, report, dt, parameters);
  Eigen::Vector3d gap = posture.X_FR.vector() - next.mean.head<3>();
  gap.z() = wrap_angle(gap.z());
  // A jump is what neither posture's error explains.
  const Eigen::Matrix3d cov_jump = next.cov.topLeftCorner<3, 3>() + track.last.cov + posture.cov;
  const double jump = chi_square_gate(3, parameters.jump_probability);
  if (!(squared_mahalanobis(gap, cov_jump) <= jump)) {
    const PostureStep step = kind_of_jump(next.mean.head<3>(), posture.X_FR, far);
    start(track, posture, report.exposure, parameters);
    return step;
  }
  // No posture is exact, and two in one moment must not make the filter singular.
  constexpr double kLeastVar = 1e-6;  // m^2, rad^2
  const Eigen::Matrix3d noise = report.cov_shake + kLeastVar * Eigen::Matrix3d::Identity();
  const Eigen::LLT<Eigen::Matrix3d> steady(Eigen::Matrix3d(next.cov.topLeftCorner<3, 3>() + noise));
  const Eigen::Matrix<double, 6, 3> gain = steady.solve(next.cov.topRows<3>()).transpose();
  next.mean += gain * gap;
  next.mean(2) = wrap_angle(next.mean(2));
  // Joseph's form keeps the covariance positive.
  Matrix6 keep = Matrix6::Identity();
  keep.leftCols<3>() -= gain;
  const Matrix6 cov = keep * next.cov * keep.transpose() + gain * noise * gain.transpose();
  next.cov = 0.5 * (cov + cov.transpose());
  next.last = posture;
  next.time = report.exposure;
  track = next;
  return PostureStep::kSteady;
}

CarriedPosture carried_to(const PostureTrack& track,
                          HostTime now,
                          const TeammateParameters& parameters) {
  const double dt = std::max(0.0, to_seconds(now - track.time));
  const Eigen::Vector3d velocity = track.mean.tail<3>();
  const Eigen::Vector3d posture = track.last.X_FR.vector() + dt * velocity;
  CarriedPosture carried;
  carried.X_FR = {posture.x(), posture.y(), posture.z()};
  carried.v_FR = {velocity.x(), velocity.y()};
  // The velocity's error and the last posture's go together: their covariance is the gain times
  // the posture's, which is the filter's own block.
  const Eigen::Matrix3d cross = track.cov.topRightCorner<3, 3>();
  const Eigen::Matrix3d psd = acceleration_psd(parameters).asDiagonal();
  carried.cov_since = dt * dt * track.cov.bottomRightCorner<3, 3>() + (dt * dt * dt / 3.0) * psd;
  const Eigen::Matrix3d cov = track.last.cov + dt * (cross + cross.transpose()) + carried.cov_since;
  carried.cov = 0.5 * (cov + cov.transpose());
  return carried;
}

PostureStep take_frame(Teammate& teammate,
                       const ObservationId& id,
                       const PostureReport& report,
                       const Parameters& parameters) {
  const HostTime exposure = report.exposure;
  PostureStep step = PostureStep::kSteady;
  if (teammate.boot != id.boot) {
    // One that spoke before and speaks again: two are alive. A new one: a restart.
    const bool is_back = teammate.other_boot == id.boot &&
                         exposure - teammate.other_seen <= parameters.teammate.duplicate_memory;
    if (is_back) teammate.duplicate_seen = exposure;
    teammate.other_boot = teammate.boot;
    teammate.other_seen = teammate.seen;
    teammate.boot = id.boot;
    teammate.posture = PostureTrack{};
    step = PostureStep::kNewProcess;
  }
  teammate.seen = std::max(teammate.seen, exposure);
  teammate.frame = id.sequence;
  teammate.status = report.posture.status;
  teammate.half_log_odds = report.posture.half_log_odds;
  if (report.posture.status == PostureStatus::kLost) return step;
  const PostureStep next =
      take_posture(teammate.posture, report, parameters.teammate, parameters.trust.jump);
  return step == PostureStep::kSteady ? next : step;
}

bool is_resolved(PostureStatus status, double half_log_odds, const TeammateParameters& parameters) {
  return status == PostureStatus::kOk ||
         (status == PostureStatus::kAmbiguous && half_log_odds >= parameters.resolved_log_odds);
}

Quarantine quarantine_of(const Teammate& teammate,
                         HostTime now,
                         const TeammateParameters& parameters) {
  if (now - teammate.duplicate_seen <= parameters.duplicate_memory) {
    return Quarantine::kDuplicateId;
  }
  if (!is_resolved(teammate.status, teammate.half_log_odds, parameters)) {
    return Quarantine::kNoPosture;
  }
  return Quarantine::kNone;
}

}  // namespace teamsight::fusion
