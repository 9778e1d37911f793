// bench/fuse_score/bound.cpp: see bench/fuse_score/bound.hpp.
#include "bench/fuse_score/bound.hpp"

#include <cmath>

namespace teamsight::score {
namespace {

using play::Moment;
using play::Play;
using play::TrueBall;

constexpr double kUnknown = 100.0;                 // m^2 and (m/s)^2: nothing is known
constexpr double kStudentInformation = 5.0 / 7.0;  // of Student's t, 4 degrees: (n + 1)/(n + 3)

/// The ray's (azimuth, elevation, angular radius) as a function of ball, posture and calibration.
struct RayModel {
  double ball_radius;

  [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& p_F,
                                           const Eigen::Matrix<double, 7, 1>& q) const {
    const double c = std::cos(q(2));
    const double s = std::sin(q(2));
    const Eigen::Vector2d way = p_F.head<2>() - q.head<2>();
    const Eigen::Vector3d p_R(c * way.x() + s * way.y(), -s * way.x() + c * way.y(), p_F.z());
    const double range = p_R.head<2>().norm();
    const double drop = play::kMirrorHeight - p_R.z();
    return {std::atan2(p_R.y(), p_R.x()) + q(4) + q(5),
            -std::atan2(drop, range * (1.0 + q(3))) + q(6),
            std::asin(std::min(0.9, ball_radius / std::hypot(range, drop)))};
  }
};

/// Of each component of a kick's velocity, which has any direction; (m/s)^2.
double kick_variance(const play::PlayParameters& play) {
  const double slow = play.min_kick;
  const double fast = play.max_kick;
  return (slow * slow + slow * fast + fast * fast) / 6.0;
}

}  // namespace

BoundFilter::BoundFilter(const play::PlayLog& log) : log_(&log) {
  const play::PerceptionParameters& eyes = log.scenario.perception;
  const int robots = log.scenario.play.own;
  const int size = kBall + kPerRobot * robots;
  Eigen::VectorXd var = Eigen::VectorXd::Constant(size, kUnknown);
  for (int robot = 0; robot < robots; ++robot) {
    const double p = eyes.sigma_posture_position;
    const double d = eyes.sigma_direction_slow;
    const double h = eyes.sigma_posture_heading;
    var.segment<kPerRobot>(column(robot)) << p * p, p * p, h * h, std::pow(eyes.sigma_scale, 2),
        std::pow(eyes.sigma_azimuth_offset, 2), d * d, d * d;
  }
  cov_ = var.asDiagonal();
  stationary_ = cov_;
}

/// One step of the ball's rows: motion, and what happened to its velocity.
void BoundFilter::step_ball() {
  const TrueBall& before = log_->at(time_).balls[0];
  time_ += Play::kStep;
  const TrueBall& after = log_->at(time_).balls[0];
  cov_.topRows(3) += Play::kStep * cov_.middleRows(3, 3);
  cov_.leftCols(3) += Play::kStep * cov_.middleCols(3, 3);
  if (before.bounces != after.bounces) {
    const Eigen::Vector3d kept(Play::kSpeedKept, Play::kSpeedKept, -Play::kClimbKept);
    cov_.middleRows(3, 3) = kept.asDiagonal() * cov_.middleRows(3, 3);
    cov_.middleCols(3, 3) = cov_.middleCols(3, 3) * kept.asDiagonal();
  }
  if (before.kicks != after.kicks) forget(3, 3, kick_variance(log_->scenario.play));
  if (after.is_flying) return;
  forget(2, 1, 1e-8);
  forget(5, 1, 1e-8);
}

void BoundFilter::forget(int first, int count, double var) {
  cov_.middleRows(first, count).setZero();
  cov_.middleCols(first, count).setZero();
  cov_.diagonal().segment(first, count).setConstant(var);
}

void BoundFilter::predict(double t) {
  const double from = time_;
  while (time_ + 0.5 * Play::kStep < t) step_ball();
  const play::PerceptionParameters& eyes = log_->scenario.perception;
  const double posture = std::exp(-(time_ - from) / eyes.posture_memory);
  const double direction = std::exp(-(time_ - from) / eyes.direction_memory);
  Eigen::VectorXd keep = Eigen::VectorXd::Ones(cov_.rows());
  for (int robot = 0; robot < log_->scenario.play.own; ++robot) {
    keep.segment<3>(column(robot)).setConstant(posture);
    keep.segment<2>(column(robot) + 5).setConstant(direction);
  }
  cov_ = keep.asDiagonal() * cov_ * keep.asDiagonal();
  cov_.diagonal() += ((1.0 - keep.array().square()) * stationary_.diagonal().array()).matrix();
}

void BoundFilter::add(const Eigen::RowVectorXd& slope, double var) {
  const Eigen::VectorXd gain = cov_ * slope.transpose();
  const double total = slope * gain + var;
  cov_ -= gain * gain.transpose() / total;
}

void BoundFilter::add_ray(const play::Frame& frame) {
  const play::PerceptionParameters& eyes = log_->scenario.perception;
  const Moment& moment = log_->at(frame.exposure);
  const int robot = static_cast<int>(frame.observation.id.robot) - 1;
  const RayModel model{log_->scenario.play.ball_radius};
  const Eigen::Vector3d p_F = moment.balls[0].p_F;
  Eigen::Matrix<double, 7, 1> q = Eigen::Matrix<double, 7, 1>::Zero();
  q.head<3>() = moment.players[static_cast<std::size_t>(robot)].X_FR.vector();
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(3, cov_.cols());
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    slopes.col(i) = (model(p_F + step, q) - model(p_F - step, q)) / (2.0 * kStep);
  }
  for (int i = 0; i < kPerRobot; ++i) {
    const Eigen::Matrix<double, 7, 1> step = kStep * Eigen::Matrix<double, 7, 1>::Unit(i);
    slopes.col(column(robot) + i) = (model(p_F, q + step) - model(p_F, q - step)) / (2.0 * kStep);
  }
  const double var = std::pow(eyes.sigma_direction, 2) / kStudentInformation;
  const double sigma_radius = eyes.share_radius * model(p_F, q)(2);
  add(slopes.row(0), var);
  add(slopes.row(1), var);
  add(slopes.row(2), sigma_radius * sigma_radius);
}

void BoundFilter::take(const play::Frame& frame) {
  predict(frame.exposure);
  if ((frame.seen_balls & 1U) != 0) add_ray(frame);
}

BallBound BoundFilter::at(double t) const {
  BoundFilter later = *this;
  later.predict(t);
  const bool is_flying = log_->at(t).balls[0].is_flying;
  const int n = is_flying ? 3 : 2;
  BallBound bound;
  bound.var_position = later.cov_.diagonal().head(n).sum();
  bound.var_velocity = later.cov_.diagonal().segment(3, n).sum();
  bound.is_known = bound.var_position < 0.25;
  return bound;
}

}  // namespace teamsight::score
