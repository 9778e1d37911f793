// bench/locate_score/drive.cpp: targets drawn at random, wheels with scale, noise and slip.
#include "bench/locate_score/drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/locate_score/line_view.hpp"
#include "geometry/angle.hpp"

namespace teamsight::locate_score {

namespace {

constexpr double kMargin = 0.5;  // m, of the targets from the outer lines

}  // namespace

Drive::Drive(const FieldModel& field, const DriveParameters& parameters, std::uint32_t seed)
    : half_length_(0.5 * field.length - kMargin),
      half_width_(0.5 * field.width - kMargin),
      centre_(field.centre),
      parameters_(parameters),
      random_(seed) {
  std::normal_distribution<double> scale(1.0, parameters.sigma_scale);
  way_scale_ = scale(random_);
  turn_scale_ = scale(random_);
  X_FR_ = draw_pose(field, kMargin, random_);
}

void Drive::steer() {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  if (until_-- <= 0) {
    target_F_ = centre_.vector() +
                Eigen::Vector2d(half_length_ * unit(random_), half_width_ * unit(random_));
    heading_ = std::numbers::pi * unit(random_);
    until_ = 150 + static_cast<int>(150.0 * std::abs(unit(random_)));
  }
  const Eigen::Vector2d way = target_F_ - X_FR_.origin().vector();
  const double speed =
      std::min(parameters_.max_speed, std::sqrt(parameters_.max_acceleration * way.norm()));
  const Eigen::Vector2d wanted = speed * way / std::max(way.norm(), 1e-6);
  Eigen::Vector2d change = wanted - v_F_;
  const double most = parameters_.max_acceleration * kStep;
  if (change.norm() > most) change *= most / change.norm();
  v_F_ += change;
  acceleration_R_ = X_FR_.rotation().transpose() * change / kStep;
  const double turn = std::clamp(
      2.0 * angle_difference(heading_, X_FR_.theta()), -parameters_.max_turn, parameters_.max_turn);
  omega_ += std::clamp(turn - omega_, -6.0 * kStep, 6.0 * kStep);
}

vision::WheelReading Drive::step() {
  std::normal_distribution<double> normal(0.0, 1.0);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  if (!parameters_.standing) steer();
  const Eigen::Vector2d v_R = X_FR_.rotation().transpose() * v_F_;
  X_FR_ = {
      X_FR_.x() + v_F_.x() * kStep, X_FR_.y() + v_F_.y() * kStep, X_FR_.theta() + omega_ * kStep};
  now_ += from_seconds(kStep);
  if (slipping_ > 0) {
    --slipping_;
  } else if (unit(random_) < parameters_.slips_per_second * kStep) {
    slipping_ = 50;
    slip_ = unit(random_) < 0.5 ? 0.2 : 2.0;
  }
  const double counted = slipping_ > 0 ? slip_ : 1.0;
  vision::WheelReading reading;
  reading.stamp = now_;
  const double moves = parameters_.standing ? 0.0 : 1.0;  // wheels that stand have no noise
  reading.v_R = {counted * way_scale_ * v_R.x() + moves * parameters_.sigma_v * normal(random_),
                 counted * way_scale_ * v_R.y() + moves * parameters_.sigma_v * normal(random_)};
  reading.omega = turn_scale_ * omega_ + moves * parameters_.sigma_omega * normal(random_);
  reading.sigma_v = parameters_.sigma_v;
  reading.sigma_omega = parameters_.sigma_omega;
  X_DR_ = X_DR_ *
          Pose<Robot, Robot>(reading.v_R.x * kStep, reading.v_R.y * kStep, reading.omega * kStep);
  reading.X_DR = X_DR_;
  return reading;
}

void Drive::kidnap(const Pose<Field, Robot>& X_FR) {
  X_FR_ = X_FR;
  v_F_.setZero();
  omega_ = 0.0;
}

}  // namespace teamsight::locate_score
