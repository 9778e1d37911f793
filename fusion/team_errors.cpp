// fusion/team_errors.cpp: see fusion/team_errors.hpp.
#include "fusion/team_errors.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace teamsight::fusion {
namespace {

constexpr double kLeastShare = 1e-3;  // root of a share of a covariance that is not divided by

/// The smallest generalised eigenvalue of (after, before): below 1 where the covariance shrank.
double least_growth(const Eigen::Matrix3d& before, const Eigen::Matrix3d& after) {
  const Eigen::LLT<Eigen::Matrix3d> factor(before);
  const Eigen::Matrix3d half = factor.matrixL().solve(after);
  const Eigen::Matrix3d whitened = factor.matrixL().solve(half.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(whitened, Eigen::EigenvaluesOnly);
  return std::max(0.0, axes.eigenvalues().minCoeff());
}

/// The nearest matrix that is no less than zero.
Eigen::Matrix3d positive_part(const Eigen::Matrix3d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(0.5 * (matrix + matrix.transpose()));
  return axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).asDiagonal() *
         axes.eigenvectors().transpose();
}

/// With a bias of unknown direction beside it.
Eigen::Matrix3d with_bias(const Eigen::Matrix3d& cov, double sigma_bias) {
  const double var = sigma_bias * sigma_bias;
  return cov + Eigen::Matrix3d(Eigen::Vector3d(var, var, 0.0).asDiagonal());
}

/// A step of a posture that only counts its wheels.
struct DeadReckoning {
  Eigen::Matrix3d keep{Eigen::Matrix3d::Identity()};  // by how much errors before are errors after
  Eigen::Vector2d drift{Eigen::Vector2d::Zero()};     // what the error of the heading adds; m
};

/// How a posture's error is carried along by wheels: a wrong heading leads aside.
///
/// @param error  of the heading; rad
DeadReckoning dead_reckoning(const Pose<Field, Robot>& from,
                             const Pose<Field, Robot>& to,
                             double error) {
  const Eigen::Vector2d said = (to.vector() - from.vector()).head<2>();
  const Eigen::Vector2d way = Eigen::Rotation2Dd(-error) * said;
  DeadReckoning step;
  step.keep(0, 2) = -way.y();
  step.keep(1, 2) = way.x();
  step.drift = said - way;
  return step;
}

}  // namespace

ErrorPlace TeamErrors::place_of(RobotId robot) const {
  for (int place = 0; place < robots_; ++place) {
    if (known_[static_cast<std::size_t>(place)].robot == robot) return place;
  }
  return kNoPlace;
}

ErrorPlace TeamErrors::make_place(RobotId robot, HostTime exposure) {
  if (robots_ < kMaxErrorRobots) return robots_++;
  const auto oldest = std::min_element(
      known_.begin(), known_.end(), [](auto& a, auto& b) { return a.seen < b.seen; });
  if (exposure - oldest->seen <= parameters_.forget_age) return kNoPlace;
  oldest->robot = robot;
  return static_cast<ErrorPlace>(oldest - known_.begin());
}

void TeamErrors::restart(ErrorPlace place, const Eigen::Matrix3d& cov_posture) {
  const int at = kErrorSize * place;
  mean_.segment<kErrorSize>(at).setZero();
  cov_.middleRows<kErrorSize>(at).setZero();
  cov_.middleCols<kErrorSize>(at).setZero();
  cov_.block<3, 3>(at, at) = cov_posture;
  cov_(at + 3, at + 3) = parameters_.sigma_scale * parameters_.sigma_scale;
}

ErrorMatrix TeamErrors::carry(ErrorPlace place,
                              const PostureEstimate& posture,
                              const PostureJitter& jitter,
                              double sigma_bias,
                              double dt) {
  const int at = kErrorSize * place;
  const Known& known = known_[static_cast<std::size_t>(place)];
  const PostureEstimate& said = known.said;
  const double growth = least_growth(said.cov, posture.cov);
  ErrorMatrix keep = ErrorMatrix::Zero();
  auto mean = mean_.segment<kErrorSize>(at);
  ErrorVector drift = ErrorVector::Zero();
  if (growth > 1.0 + 1e-9) {
    const DeadReckoning step = dead_reckoning(said.X_FR, posture.X_FR, mean(2));
    keep.topLeftCorner<3, 3>() = step.keep;
    drift.head<2>() = step.drift - step.keep.topRightCorner<2, 1>() * mean(2);
  } else {
    const Duration memory = sigma_bias > 0.0 ? parameters_.bias_memory : parameters_.posture_memory;
    const double share = std::exp(-dt / to_seconds(memory)) * std::sqrt(std::min(1.0, growth));
    keep.topLeftCorner<3, 3>() = share * Eigen::Matrix3d::Identity();
  }
  // What turns out to be drawn anew each time was no error that lasts.
  const Eigen::Vector3d left = jitter.lasting_root()
                                   .cwiseQuotient(known.jitter.lasting_root().cwiseMax(kLeastShare))
                                   .cwiseMin(1.0);
  keep.topLeftCorner<3, 3>() *= left.asDiagonal();
  keep(3, 3) = std::exp(-dt / to_seconds(parameters_.scale_memory));
  const auto keep_posture = keep.topLeftCorner<3, 3>();
  const Eigen::Matrix3d news =
      positive_part(with_bias(jitter.lasting(posture.cov), sigma_bias) -
                    keep_posture * with_bias(known.jitter.lasting(said.cov), known.sigma_bias) *
                        keep_posture.transpose());
  mean = (keep * mean + drift).eval();
  cov_.middleRows<kErrorSize>(at) = (keep * cov_.middleRows<kErrorSize>(at)).eval();
  cov_.middleCols<kErrorSize>(at) = (cov_.middleCols<kErrorSize>(at) * keep.transpose()).eval();
  cov_.block<3, 3>(at, at) += news;
  cov_(at + 3, at + 3) +=
      (1.0 - keep(3, 3) * keep(3, 3)) * parameters_.sigma_scale * parameters_.sigma_scale;
  return keep;
}

ErrorMatrix TeamErrors::report(RobotId robot,
                               const PostureEstimate& posture,
                               HostTime exposure,
                               const PostureNews& news) {
  ErrorPlace place = place_of(robot);
  const bool is_unknown = place == kNoPlace;
  if (is_unknown) place = make_place(robot, exposure);
  ErrorMatrix keep = ErrorMatrix::Zero();
  if (place == kNoPlace) return keep;
  Known& known = known_[static_cast<std::size_t>(place)];
  if (is_unknown) known = Known{};  // whoever had the place shook in a way of its own
  if (is_unknown || news.is_new) {
    known.jitter.interrupt();
    known.jitter.take(posture.X_FR, posture.cov, exposure, parameters_);
    restart(place, with_bias(known.jitter.lasting(posture.cov), news.sigma_bias));
  } else {
    PostureJitter jitter = known.jitter;
    jitter.take(posture.X_FR, posture.cov, exposure, parameters_);
    const double dt = std::max(0.0, to_seconds(exposure - known.seen));
    keep = carry(place, posture, jitter, news.sigma_bias, dt);
    known.jitter = jitter;
  }
  known.robot = robot;
  known.seen = std::max(known.seen, exposure);
  known.said = posture;
  known.sigma_bias = news.sigma_bias;
  return keep;
}

Eigen::Matrix3d TeamErrors::fresh(ErrorPlace place, const PostureEstimate& posture) const {
  if (place == kNoPlace) return posture.cov;
  return known_[static_cast<std::size_t>(place)].jitter.fresh(posture.cov);
}

Eigen::Matrix3d TeamErrors::shake(RobotId robot, const PostureEstimate& posture) const {
  const ErrorPlace place = place_of(robot);
  const bool is_measured =
      place != kNoPlace && known_[static_cast<std::size_t>(place)].jitter.is_measured();
  return is_measured ? fresh(place, posture) : posture.cov;
}

ErrorVector TeamErrors::mean(ErrorPlace place) const {
  return mean_.segment<kErrorSize>(kErrorSize * place);
}

ErrorMatrix TeamErrors::cov(ErrorPlace place) const {
  return cov_.block<kErrorSize, kErrorSize>(kErrorSize * place, kErrorSize * place);
}

Eigen::Matrix<double, kErrorSize, kAllErrors> TeamErrors::cov_with_all(ErrorPlace place) const {
  return cov_.middleRows<kErrorSize>(kErrorSize * place);
}

TeamErrors::Lesson TeamErrors::lesson_of(const Residual& residual) const {
  Lesson lesson;
  lesson.slope.setZero();
  lesson.cov_slope.setZero();
  lesson.surprise = residual.value;
  const int n = active();
  // Nowhere else is the slope other than zero: there are two small products, no large one.
  const auto add = [&](ErrorPlace place, const Eigen::Matrix<double, 2, kErrorSize>& slope) {
    if (place == kNoPlace) return;
    const int at = kErrorSize * place;
    lesson.slope.middleCols<kErrorSize>(at) += slope;
    lesson.surprise -= slope * mean(place);
    lesson.cov_slope.topRows(n) +=
        cov_.middleCols<kErrorSize>(at).topRows(n).lazyProduct(slope.transpose());
  };
  add(residual.observer, residual.slope_observer);
  add(residual.watched, residual.slope_watched);
  Eigen::Matrix2d cov = residual.cov;
  const auto spread = [&](ErrorPlace place, const Eigen::Matrix<double, 2, kErrorSize>& slope) {
    if (place != kNoPlace)
      cov += slope * lesson.cov_slope.middleRows<kErrorSize>(kErrorSize * place);
  };
  spread(residual.observer, residual.slope_observer);
  spread(residual.watched, residual.slope_watched);
  lesson.inverse = cov.inverse();
  return lesson;
}

void TeamErrors::learn(const Lesson& lesson) {
  const int n = active();
  const Eigen::Matrix<double, kAllErrors, 2> gain = lesson.cov_slope * lesson.inverse;
  mean_ += gain * lesson.surprise;
  auto cov = cov_.topLeftCorner(n, n);
  cov -= gain.topRows(n).lazyProduct(lesson.cov_slope.topRows(n).transpose());
  // Rounding must not add up to a covariance that is none.
  cov = (0.5 * (cov + cov.transpose())).eval();
}

Eigen::Matrix<double, 2, kErrorSize> place_slope(const Eigen::Vector2d& way_F) {
  return (Eigen::Matrix<double, 2, kErrorSize>() << 1.0,
          0.0,
          -way_F.y(),
          way_F.x(),
          0.0,
          1.0,
          way_F.x(),
          way_F.y())
      .finished();
}

}  // namespace teamsight::fusion
