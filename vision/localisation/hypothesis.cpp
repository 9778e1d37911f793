// vision/localisation/hypothesis.cpp: prediction, correction, merging.
#include "vision/localisation/hypothesis.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "geometry/angle.hpp"

namespace teamsight::vision {

namespace {

constexpr double kSamePlace = 0.2;        // m
constexpr double kSameHeading = 0.15;     // rad
constexpr double kTooUnlikely = -12.0;    // log
constexpr double kUnknownVelocity = 2.0;  // of the variance of a robot of which nothing is known
constexpr double kCorrelationTime = 0.1;  // s, of the acceleration of a robot in play

bool is_same(const Pose<Field, Robot>& a, const Pose<Field, Robot>& b) {
  return (a.origin().vector() - b.origin().vector()).norm() < kSamePlace &&
         std::abs(angle_difference(a.theta(), b.theta())) < kSameHeading;
}

// d(X_FR * step)/d X_FR: the step's offset turns with the robot.
Eigen::Matrix3d jacobian_of_step(const Pose<Field, Robot>& X_FR, const Pose<Robot, Robot>& step) {
  const Eigen::Vector2d way = X_FR.rotation() * Eigen::Vector2d(step.x(), step.y());
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian(0, 2) = -way.y();
  jacobian(1, 2) = way.x();
  return jacobian;
}

}  // namespace

Eigen::Matrix3d turned(const Eigen::Matrix2d& R_FR) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = R_FR;
  return turn;
}

double Hypothesis::sigma_position() const {
  return std::sqrt(std::max(cov(0, 0), cov(1, 1)));
}

void carry(Hypothesis& hypothesis, const Walk& walk, const WheelReading& newest) {
  const Eigen::Matrix3d by_pose = jacobian_of_step(hypothesis.X_FR, walk.step);
  const Eigen::Matrix3d turn = turned(hypothesis.X_FR.rotation());
  const Eigen::Matrix3d cov =
      by_pose * hypothesis.cov_pose() * by_pose.transpose() + turn * walk.cov * turn.transpose();
  hypothesis.X_FR = hypothesis.X_FR * walk.step;
  hypothesis.v_R = newest.v_R;
  hypothesis.omega = newest.omega;
  const double sigma_v = std::max(newest.sigma_v, 0.05);
  const double sigma_omega = std::max(newest.sigma_omega, 0.05);
  hypothesis.cov.setZero();
  hypothesis.cov.topLeftCorner<3, 3>() = 0.5 * (cov + cov.transpose());
  hypothesis.cov.diagonal().tail<3>() << sigma_v * sigma_v, sigma_v * sigma_v,
      sigma_omega * sigma_omega;
}

void coast(Hypothesis& hypothesis, double seconds, const DriveLimits& limits) {
  if (seconds <= 0.0) return;
  const Pose<Robot, Robot> step{
      hypothesis.v_R.x * seconds, hypothesis.v_R.y * seconds, hypothesis.omega * seconds};
  const Eigen::Matrix3d turn = turned(hypothesis.X_FR.rotation());
  Matrix6 by_state = Matrix6::Identity();
  by_state.topLeftCorner<3, 3>() = jacobian_of_step(hypothesis.X_FR, step);
  by_state.topRightCorner<3, 3>() = seconds * turn;
  const double a2 = limits.sigma_acceleration * limits.sigma_acceleration * kCorrelationTime;
  const double t2 =
      limits.sigma_turn_acceleration * limits.sigma_turn_acceleration * kCorrelationTime;
  const Eigen::Vector3d density(a2, a2, t2);
  const Eigen::Matrix3d power = density.asDiagonal();
  Matrix6 noise;
  noise.topLeftCorner<3, 3>() = std::pow(seconds, 3) / 3.0 * turn * power * turn.transpose();
  noise.topRightCorner<3, 3>() = seconds * seconds / 2.0 * turn * power;
  noise.bottomLeftCorner<3, 3>() = noise.topRightCorner<3, 3>().transpose();
  noise.bottomRightCorner<3, 3>() = seconds * power;
  const Matrix6 cov = by_state * hypothesis.cov * by_state.transpose() + noise;
  hypothesis.cov = 0.5 * (cov + cov.transpose());
  hypothesis.X_FR = hypothesis.X_FR * step;
  // A velocity that nobody measured fades: nobody drives straight on for ever.
  const double most = std::pow(limits.sigma_velocity, 2);
  if (hypothesis.cov(3, 3) > kUnknownVelocity * most ||
      hypothesis.cov(4, 4) > kUnknownVelocity * most) {
    hypothesis.v_R = {};
    hypothesis.omega = 0.0;
    hypothesis.cov.topRightCorner<3, 3>().setZero();
    hypothesis.cov.bottomLeftCorner<3, 3>().setZero();
    hypothesis.cov.bottomRightCorner<3, 3>() =
        Eigen::Vector3d(most, most, std::pow(limits.sigma_omega, 2)).asDiagonal();
  }
}

Innovation innovation_of(const Hypothesis& hypothesis,
                         const Pose<Field, Robot>& measured,
                         const Eigen::Matrix3d& cov) {
  Innovation innovation;
  innovation.gap = measured.vector() - hypothesis.X_FR.vector();
  innovation.gap.z() = wrap_angle(innovation.gap.z());
  const Eigen::Matrix3d cov_gap = hypothesis.cov_pose() + cov;
  innovation.nis = innovation.gap.dot(cov_gap.llt().solve(innovation.gap));
  return innovation;
}

void correct(Hypothesis& hypothesis,
             const Pose<Field, Robot>& measured,
             const Eigen::Matrix3d& cov) {
  const Eigen::Vector3d gap = innovation_of(hypothesis, measured, cov).gap;
  const Eigen::Matrix3d cov_gap = hypothesis.cov_pose() + cov;
  const Eigen::Matrix<double, 6, 3> gain =
      cov_gap.llt().solve(hypothesis.cov.topRows<3>()).transpose();
  const Eigen::Matrix<double, 6, 1> change = gain * gap;
  hypothesis.X_FR = {hypothesis.X_FR.x() + change(0),
                     hypothesis.X_FR.y() + change(1),
                     hypothesis.X_FR.theta() + change(2)};
  hypothesis.v_R = {hypothesis.v_R.x + change(3), hypothesis.v_R.y + change(4)};
  hypothesis.omega += change(5);
  Matrix6 keep = Matrix6::Identity();
  keep.leftCols<3>() -= gain;
  const Matrix6 next = keep * hypothesis.cov * keep.transpose() + gain * cov * gain.transpose();
  hypothesis.cov = 0.5 * (next + next.transpose());
}

Hypothesis mirrored(const Hypothesis& hypothesis, const Point<Field>& centre) {
  Hypothesis image = hypothesis;
  image.X_FR = mirrored(hypothesis.X_FR, centre);
  // Half a turn flips both signs of a position in F; heading and velocities in R stay.
  image.cov.topRightCorner<2, 4>() *= -1.0;
  image.cov.bottomLeftCorner<4, 2>() *= -1.0;
  image.half_log_odds = -hypothesis.half_log_odds;
  return image;
}

void Belief::add(const Hypothesis& hypothesis) {
  if (count < kMaxHypotheses) {
    places[count++] = hypothesis;
    return;
  }
  const auto least = std::ranges::min_element(
      places, [](const auto& a, const auto& b) { return a.log_weight < b.log_weight; });
  if (least->log_weight < hypothesis.log_weight) *least = hypothesis;
}

void Belief::tidy(bool symmetric, const Point<Field>& centre) {
  std::ranges::sort(all(),
                    [](const auto& a, const auto& b) { return a.log_weight > b.log_weight; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Hypothesis& one = places[i];
    const bool is_known =
        std::any_of(places.begin(),
                    places.begin() + static_cast<std::ptrdiff_t>(kept),
                    [&](const auto& better) {
                      return is_same(one.X_FR, better.X_FR) ||
                             (symmetric && is_same(mirrored(one.X_FR, centre), better.X_FR));
                    });
    const bool is_hopeless = one.log_weight < places[0].log_weight + kTooUnlikely;
    if (!is_known && !is_hopeless) places[kept++] = one;
  }
  count = kept;
  if (count == 0) return;
  const double best = places[0].log_weight;
  for (Hypothesis& one : all()) one.log_weight -= best;
}

double Belief::share_of_best() const {
  double sum = 0.0;
  for (const Hypothesis& one : all()) sum += std::exp(one.log_weight - places[0].log_weight);
  return sum > 0.0 ? 1.0 / sum : 0.0;
}

}  // namespace teamsight::vision
