// fusion/planar_filter.cpp: see fusion/planar_filter.hpp.
#include "fusion/planar_filter.hpp"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace teamsight::fusion {
namespace {

Eigen::Matrix4d inverse_of(const Eigen::Matrix4d& positive) {
  const Eigen::Matrix4d inverse = positive.llt().solve(Eigen::Matrix4d::Identity());
  return 0.5 * (inverse + inverse.transpose());
}

}  // namespace

PlanarFilter PlanarFilter::from(const PlanarMoments& moments) {
  PlanarFilter filter;
  filter.info_ = inverse_of(moments.cov);
  filter.info_mean_ = filter.info_ * moments.mean;
  return filter;
}

PlanarMoments PlanarFilter::moments() const {
  PlanarMoments moments;
  moments.cov = inverse_of(info_);
  moments.mean = moments.cov * info_mean_;
  return moments;
}

PlanarStep planar_step(double dt, const PlanarMotion& motion) {
  const double left = std::exp(-motion.velocity_decay * dt);
  const double reach = motion.velocity_decay > 1e-9 ? (1.0 - left) / motion.velocity_decay : dt;
  PlanarStep step;
  step.transition.setIdentity();
  step.transition.topRightCorner<2, 2>() = reach * Eigen::Matrix2d::Identity();
  step.transition.bottomRightCorner<2, 2>() = left * Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d one = motion.acceleration_psd * Eigen::Matrix2d::Identity();
  step.disturbance << one * (dt * dt * dt / 3.0), one * (dt * dt / 2.0), one * (dt * dt / 2.0),
      one * dt;
  return step;
}

PlanarMoments predicted(const PlanarMoments& moments, double dt, const PlanarMotion& motion) {
  if (dt <= 0.0) return moments;
  const PlanarStep step = planar_step(dt, motion);
  PlanarMoments later;
  later.mean = step.transition * moments.mean;
  later.cov = step.transition * moments.cov * step.transition.transpose() + step.disturbance;
  return later;
}

void PlanarFilter::predict(double dt, const PlanarMotion& motion) {
  if (dt > 0.0) *this = from(predicted(moments(), dt, motion));
}

void PlanarFilter::update(const PlanarMeasurement& measurement) {
  const Eigen::Matrix2d weight = measurement.cov_F.inverse();
  info_.topLeftCorner<2, 2>() += 0.5 * (weight + weight.transpose());
  info_mean_.head<2>() += weight * measurement.p_F;
}

PlanarInnovation innovation(const PlanarMoments& moments, const PlanarMeasurement& measurement) {
  const Eigen::Matrix2d cov = moments.cov.topLeftCorner<2, 2>() + measurement.cov_F;
  const Eigen::Vector2d gap = measurement.p_F - moments.mean.head<2>();
  return {gap.dot(cov.inverse() * gap), std::log(cov.determinant())};
}

}  // namespace teamsight::fusion
