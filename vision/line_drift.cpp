// vision/line_drift.cpp: normal equations of a frame, and a test over frames.
#include "vision/line_drift.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "geometry/angle.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::vision {

namespace {

constexpr std::uint16_t kFewestPoints = 40;
constexpr double kFewestFrames = 12.0;  // as whole ones
constexpr double kClears = 0.7;         // of the limit
constexpr int kUnknowns = 3;

// Metres on the floor, in R, per px of (too large, shifted right, shifted up) at a point.
Eigen::Matrix<double, 2, 3> floor_slopes(const LinePoint& point, const DriftGeometry& geometry) {
  const RayTable& rays = *geometry.rays;
  const auto column = static_cast<std::uint32_t>(std::clamp(point.u_px, 0.0, rays.width() - 1.0));
  const auto row = static_cast<std::uint32_t>(std::clamp(point.v_px, 0.0, rays.height() - 1.0));
  const PixelRay& ray = rays.at(column, row);
  const Eigen::Vector2d from_centre{point.u_px - geometry.centre.u, geometry.centre.v - point.v_px};
  const Eigen::Vector2d direction = from_centre / std::max(from_centre.norm(), 1e-6);
  const double c = direction.x();
  const double s = direction.y();
  const Eigen::Vector2d p_R = point.p_R.vector();
  const Eigen::Vector2d away = p_R / std::max(p_R.norm(), 1e-6);
  // Counter-clockwise in the picture, on the floor.
  const Eigen::Vector2d around =
      (geometry.mirrored ? -1.0 : 1.0) * Eigen::Vector2d(-away.y(), away.x());
  const Eigen::Vector2d outwards = static_cast<double>(ray.radial_footprint) * away;
  const Eigen::Vector2d sideways = static_cast<double>(ray.tangential_footprint) * around;
  Eigen::Matrix<double, 2, 3> slopes;
  slopes.col(0) = outwards;
  slopes.col(1) = c * outwards - s * sideways;
  slopes.col(2) = s * outwards + c * sideways;
  return slopes;
}

/// What one frame knows better than the limit, and the rest left out.
struct Told {
  Eigen::Matrix3d info{Eigen::Matrix3d::Zero()};
  Eigen::Vector3d vector{Eigen::Vector3d::Zero()};
  double square{0.0};  // estimate' info estimate
  int directions{0};   // of the three unknowns' space
};

Told told_by(const DriftEvidence& evidence, double limit_px) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(evidence.info);
  Told told;
  for (int i = 0; i < kUnknowns; ++i) {
    const double info = solver.eigenvalues()[i];
    if (!(info * limit_px * limit_px > 1.0)) continue;
    const Eigen::Vector3d direction = solver.eigenvectors().col(i);
    const double along = direction.dot(evidence.vector);
    told.info += info * direction * direction.transpose();
    told.vector += along * direction;
    told.square += along * along / info;
    ++told.directions;
  }
  return told;
}

}  // namespace

DriftEvidence drift_evidence(std::span<const LinePoint> points,
                             const std::vector<bool>& fits,
                             const LineMap& map,
                             const Pose<Field, Robot>& X_FR,
                             const DriftGeometry& geometry) {
  Eigen::Matrix3d posture = 1e-6 * Eigen::Matrix3d::Identity();
  Eigen::Matrix3d cross = Eigen::Matrix3d::Zero();
  Eigen::Vector3d posture_vector = Eigen::Vector3d::Zero();
  DriftEvidence evidence;
  const Eigen::Matrix2d R_FR = X_FR.rotation();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!fits[i]) continue;
    const Eigen::Vector2d p_RL_F = R_FR * points[i].p_R.vector();
    const NearestLine nearest = map.nearest(X_FR.origin().vector() + p_RL_F);
    const Eigen::Vector2d& n = nearest.normal_F;
    const Eigen::Vector2d n_R = R_FR.transpose() * n;
    const double weight = 1.0 / (n_R.dot(points[i].cov_R * n_R) + 1e-6);
    const Eigen::Vector3d by_posture{n.x(), n.y(), n.dot(Eigen::Vector2d(-p_RL_F.y(), p_RL_F.x()))};
    const Eigen::Vector3d by_drift = floor_slopes(points[i], geometry).transpose() * n_R;
    posture += weight * by_posture * by_posture.transpose();
    posture_vector += weight * nearest.distance * by_posture;
    cross += weight * by_drift * by_posture.transpose();
    evidence.info += weight * by_drift * by_drift.transpose();
    evidence.vector += weight * nearest.distance * by_drift;
    ++evidence.points;
  }
  if (evidence.points < kFewestPoints) return {};
  const Eigen::Matrix3d gain = cross * posture.inverse();
  evidence.info -= gain * cross.transpose();
  evidence.vector -= gain * posture_vector;
  return evidence;
}

bool DriftWatch::is_elsewhere(const Pose<Field, Robot>& X_FR) const {
  return !last_ || (X_FR.origin().vector() - last_->origin().vector()).norm() > rules_.apart ||
         std::abs(angle_difference(X_FR.theta(), last_->theta())) > rules_.apart;
}

void DriftWatch::take(const DriftEvidence& evidence, const Pose<Field, Robot>& X_FR) {
  if (evidence.points == 0 || !is_elsewhere(X_FR)) return;
  const Told told = told_by(evidence, rules_.limit_px);
  if (told.directions == 0) return;
  last_ = X_FR;
  const double kept = 1.0 - told.directions / (kUnknowns * rules_.memory);
  info_ = kept * info_ + told.info;
  vector_ = kept * vector_ + told.vector;
  square_ = kept * square_ + told.square;
  told_ = kept * told_ + told.directions;
  judge();
}

void DriftWatch::judge() {
  const Eigen::LDLT<Eigen::Matrix3d> factors(info_);
  // Frames that all leave the same direction open know no drift.
  if (!(factors.vectorD().minCoeff() * rules_.limit_px * rules_.limit_px > 1.0)) return;
  const Eigen::Vector3d estimate = factors.solve(vector_);
  const double explained = vector_.dot(estimate);
  report_.size_px = estimate.x();
  report_.shift_px = estimate.tail<2>();
  report_.drift_px = std::hypot(estimate.x(), std::sqrt(0.5) * report_.shift_px.norm());
  if (told_ < kUnknowns * kFewestFrames) return;
  // What the frames' estimates scatter about the common one, over what white noise would.
  const double scatter = (square_ - explained) / (told_ - kUnknowns);
  const double chi_square = explained / std::max(scatter, 1e-3);
  const bool is_sure = chi_square > chi_square_gate(kUnknowns, rules_.confidence);
  const double limit = report_.alarm ? kClears * rules_.limit_px : rules_.limit_px;
  report_.alarm = is_sure && report_.drift_px > limit;
}

}  // namespace teamsight::vision
