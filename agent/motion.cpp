// agent/motion.cpp: see motion.hpp.
#include "agent/motion.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::agent {
namespace {

// Postures closer in time than this say nothing of a velocity, further apart neither.
constexpr double kShortestBase = 0.02;  // s
constexpr double kLongestBase = 0.5;    // s
constexpr double kNewShare = 0.4;       // of one pair of postures in the smoothed velocity

HostTime host_time(PeerTime own_stamp) {
  return to_host_time(own_stamp, Duration{0});
}

}  // namespace

Motion::Motion(const MotionParameters& parameters, vision::StartSide start_side)
    : parameters_(parameters),
      start_side_(start_side) {}

void Motion::see(const PostureEstimate& posture, HostTime exposure) {
  if (posture.status == PostureStatus::kLost) {
    return;
  }
  const double base = known_.has_value() ? to_seconds(exposure - known_->at) : 0.0;
  if (base >= kShortestBase && base <= kLongestBase) {
    const Pose<Robot, Robot> step = known_->X_FR.inverse() * posture.X_FR;
    const double keep = 1.0 - kNewShare;
    v_R_seen_.x = keep * v_R_seen_.x + kNewShare * step.x() / base;
    v_R_seen_.y = keep * v_R_seen_.y + kNewShare * step.y() / base;
    omega_seen_ = keep * omega_seen_ + kNewShare * step.theta() / base;
  } else if (base > kLongestBase) {
    v_R_seen_ = {};
    omega_seen_ = 0.0;
  }
  known_ = Known{exposure, posture.X_FR, posture.cov, posture.half_log_odds};
}

void Motion::place(const Pose<Field, Robot>& X_FR, const Eigen::Matrix3d& cov, HostTime when) {
  // Whoever says where the robot stands also says on which half.
  known_ = Known{when, X_FR, cov, vision::kMaxHalfLogOdds};
  v_R_seen_ = {};
  omega_seen_ = 0.0;
}

void Motion::roll(const bus::Odometry& odometry) {
  const HostTime stamp = host_time(odometry.stamp);
  if (drive_count_ > 0 && stamp <= host_time(newest_.stamp)) {
    return;
  }
  drive_[drive_count_++ % drive_.size()] = {stamp, odometry.X_DR};
  newest_ = odometry;
}

std::optional<Pose<Drive, Robot>> Motion::drive_at(HostTime when) const {
  const std::size_t oldest = drive_count_ > drive_.size() ? drive_count_ - drive_.size() : 0;
  for (std::size_t i = drive_count_; i > oldest; --i) {
    const DriveStep& step = drive_[(i - 1) % drive_.size()];
    if (step.stamp > when) {
      continue;
    }
    const double ahead = to_seconds(when - step.stamp);
    if (i < drive_count_) {  // between this and the next one
      const DriveStep& next = drive_[i % drive_.size()];
      const double share = ahead / to_seconds(next.stamp - step.stamp);
      const Pose<Robot, Robot> X_RR = step.X_DR.inverse() * next.X_DR;
      return step.X_DR *
             Pose<Robot, Robot>(share * X_RR.x(), share * X_RR.y(), share * X_RR.theta());
    }
    if (when - step.stamp > parameters_.odometry_stale) {
      return std::nullopt;
    }
    return step.X_DR *
           Pose<Robot, Robot>(newest_.v_R.x * ahead, newest_.v_R.y * ahead, newest_.omega * ahead);
  }
  return std::nullopt;
}

vision::MotionPrior Motion::prior_at(HostTime exposure) const {
  vision::MotionPrior prior;
  prior.start_side = start_side_;
  if (!known_.has_value()) {
    return prior;
  }
  const auto then_X_DR = drive_at(known_->at);
  const auto now_X_DR = drive_at(exposure);
  const bool has_wheels = then_X_DR.has_value() && now_X_DR.has_value();
  const double passed = std::abs(to_seconds(exposure - known_->at));
  const double sigma_v = has_wheels ? parameters_.sigma_slip : parameters_.sigma_v;
  const double sigma_omega = has_wheels ? parameters_.sigma_turn_slip : parameters_.sigma_omega;
  const double growth = sigma_v * passed;
  const double turn = sigma_omega * passed;
  Eigen::Matrix3d cov = known_->cov;
  cov.diagonal() += Eigen::Vector3d(growth * growth, growth * growth, turn * turn);
  if (std::sqrt(std::max(cov(0, 0), cov(1, 1))) > parameters_.sigma_useless) {
    return prior;
  }
  prior.X_FR = has_wheels ? known_->X_FR * (then_X_DR->inverse() * *now_X_DR) : known_->X_FR;
  prior.cov = cov;
  prior.half_log_odds = known_->half_log_odds;
  return prior;
}

bool Motion::has_fresh_odometry(HostTime when) const {
  return drive_count_ > 0 && when - host_time(newest_.stamp) < parameters_.odometry_stale;
}

Velocity<Robot> Motion::velocity(HostTime when) const {
  if (has_fresh_odometry(when)) {
    return newest_.v_R;
  }
  const bool is_known = known_.has_value() && to_seconds(when - known_->at) < kLongestBase;
  return is_known ? v_R_seen_ : Velocity<Robot>{};
}

double Motion::omega(HostTime when) const {
  if (has_fresh_odometry(when)) {
    return newest_.omega;
  }
  const bool is_known = known_.has_value() && to_seconds(when - known_->at) < kLongestBase;
  return is_known ? omega_seen_ : 0.0;
}

}  // namespace teamsight::agent
