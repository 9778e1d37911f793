// vision/localisation/motion_log.cpp: rings of readings, looked up between their stamps.
#include "vision/localisation/motion_log.hpp"

#include <cmath>

namespace teamsight::vision {

namespace {

constexpr Duration kAccelerationBase = std::chrono::milliseconds(50);

bool is_finite(const WheelReading& r) {
  return r.X_DR.vector().allFinite() && r.v_R.vector().allFinite() && std::isfinite(r.omega) &&
         std::isfinite(r.sigma_v) && std::isfinite(r.sigma_omega);
}

double square(double x) {
  return x * x;
}

}  // namespace

InputReject MotionLog::roll(const WheelReading& reading) {
  if (!is_finite(reading)) return InputReject::kNotFinite;
  if (wheel_count_ > 0 && reading.stamp <= wheel(0).stamp) {
    if (++wheels_backwards_ < kRestart) return InputReject::kBackwards;
    wheel_count_ = 0;
  }
  wheels_backwards_ = 0;
  wheels_[wheel_count_++ % kReadings] = reading;
  return InputReject::kNone;
}

InputReject MotionLog::turn(const GyroReading& reading) {
  if (!std::isfinite(reading.omega) || !(reading.sigma > 0.0)) return InputReject::kNotFinite;
  if (heading_count_ > 0 && reading.stamp <= heading(0).stamp) {
    if (++headings_backwards_ < kRestart) return InputReject::kBackwards;
    heading_count_ = 0;
  }
  headings_backwards_ = 0;
  Heading next{reading.stamp, 0.0, reading};
  if (heading_count_ > 0) {
    const Heading& last = heading(0);
    next.angle = last.angle + 0.5 * (last.reading.omega + reading.omega) *
                                  to_seconds(reading.stamp - last.stamp);
  }
  headings_[heading_count_++ % kReadings] = next;
  return InputReject::kNone;
}

const WheelReading& MotionLog::wheel(std::size_t age) const {
  return wheels_[(wheel_count_ - 1 - age) % kReadings];
}

const MotionLog::Heading& MotionLog::heading(std::size_t age) const {
  return headings_[(heading_count_ - 1 - age) % kReadings];
}

std::optional<Pose<Drive, Robot>> MotionLog::wheels_at(HostTime when) const {
  for (std::size_t age = 0; age < wheels_kept(); ++age) {
    const WheelReading& before = wheel(age);
    if (before.stamp > when) continue;
    const double ahead = to_seconds(when - before.stamp);
    if (age == 0) {
      if (when - before.stamp > parameters_.stale) return std::nullopt;
      return before.X_DR *
             Pose<Robot, Robot>(before.v_R.x * ahead, before.v_R.y * ahead, before.omega * ahead);
    }
    const WheelReading& after = wheel(age - 1);
    if (after.stamp - before.stamp > 2 * parameters_.stale) return std::nullopt;
    const double share = ahead / to_seconds(after.stamp - before.stamp);
    const Pose<Robot, Robot> X_RR = before.X_DR.inverse() * after.X_DR;
    return before.X_DR *
           Pose<Robot, Robot>(share * X_RR.x(), share * X_RR.y(), share * X_RR.theta());
  }
  return std::nullopt;
}

std::optional<double> MotionLog::heading_at(HostTime when) const {
  for (std::size_t age = 0; age < headings_kept(); ++age) {
    const Heading& before = heading(age);
    if (before.stamp > when) continue;
    const double ahead = to_seconds(when - before.stamp);
    if (age == 0 && when - before.stamp > parameters_.stale) return std::nullopt;
    if (age == 0) return before.angle + before.reading.omega * ahead;
    const Heading& after = heading(age - 1);
    const double share = ahead / to_seconds(after.stamp - before.stamp);
    return before.angle + share * (after.angle - before.angle);
  }
  return std::nullopt;
}

std::optional<Walk> MotionLog::walk(HostTime from, HostTime to, bool slipping) const {
  const auto then = wheels_at(from);
  const auto now = wheels_at(to);
  if (!then || !now || to < from) return std::nullopt;
  const WheelReading& last = wheel(0);
  const bool slips = slipping || last.slipping;
  const double seconds = to_seconds(to - from);
  // Errors that last for the correlation time add up as a random walk beyond it.
  const double spread = seconds * std::max(seconds, parameters_.correlation_time);
  Walk walk;
  walk.step = then->inverse() * *now;
  const double way = std::hypot(walk.step.x(), walk.step.y());
  const bool stands =
      way < parameters_.standing && std::abs(walk.step.theta()) < parameters_.standing;
  // Wheels that do not turn hold the robot.
  const double share = stands ? parameters_.standing_share : 1.0;
  const double sigma =
      slips ? parameters_.sigma_slip : share * std::max(parameters_.sigma_wheel, last.sigma_v);
  const double sigma_turn = slips
                                ? parameters_.sigma_slip_turn
                                : share * std::max(parameters_.sigma_wheel_turn, last.sigma_omega);
  const double var = square(sigma) * spread + square(parameters_.sigma_scale * way);
  double var_turn =
      square(sigma_turn) * spread + square(parameters_.sigma_scale * walk.step.theta());
  const auto turned_then = heading_at(from);
  const auto turned_now = heading_at(to);
  if (turned_then && turned_now) {
    const double var_gyro = square(heading(0).reading.sigma) * spread + 1e-12;
    const double trust = var_turn / (var_turn + var_gyro);
    const double turn = *turned_now - *turned_then;
    const double gap = wrap_angle(turn - walk.step.theta());
    walk.step = {walk.step.x(), walk.step.y(), walk.step.theta() + trust * gap};
    var_turn = trust * var_gyro;
  }
  walk.cov.diagonal() << var, var, var_turn;
  return walk;
}

std::optional<WheelReading> MotionLog::newest(HostTime when) const {
  if (wheel_count_ == 0 || when - wheel(0).stamp > parameters_.stale) return std::nullopt;
  return wheel(0);
}

std::optional<Eigen::Vector2d> MotionLog::acceleration(HostTime when) const {
  const WheelReading* last = nullptr;
  for (std::size_t age = 0; age < wheels_kept(); ++age) {
    const WheelReading& reading = wheel(age);
    if (reading.stamp > when) continue;
    if (last == nullptr) {
      if (when - reading.stamp > parameters_.stale) return std::nullopt;
      last = &reading;
      continue;
    }
    const Duration base = last->stamp - reading.stamp;
    if (base < kAccelerationBase / 2) continue;
    if (base > 2 * kAccelerationBase) return std::nullopt;
    return (last->v_R.vector() - reading.v_R.vector()) / to_seconds(base);
  }
  return std::nullopt;
}

}  // namespace teamsight::vision
