// vision/posture_fit.cpp: residuals, annealed Gauss-Newton steps, covariance.
#include "vision/posture_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

constexpr double kFirstWidth = 0.25;  // m, of the Geman-McClure kernel
constexpr double kLastWidth = 0.02;   // m, or 3 sigma
constexpr double kShrink = 0.7;       // per step
constexpr double kSigmas = 3.0;
constexpr int kMaxSteps = 24;
constexpr double kVoteWidth = 0.08;     // m, of the soft votes that rank candidates
constexpr double kInlierFloor = 0.05;   // m
constexpr double kOpenSigma = 0.5;      // m or rad: beyond this a direction counts as open
constexpr double kMadToSigma = 1.4826;  // of a normal distribution
constexpr double kPriorPoints = 10.0;   // how many points the claimed sigma is worth: kernel width
constexpr double kClaimPoints = 2.0;    // the same for the covariance

double width_of(const LineResidual& residual, double width, double scale) {
  return std::max({width, kLastWidth, kSigmas * scale * std::sqrt(residual.var)});
}

// The correlation of neighbours along the scan order, as a factor on the covariance: N / N_eff of a
// first order autoregression. Measured among inliers only; never below 1.
double correlation_inflation(std::span<const LineResidual> residuals, double scale) {
  double product = 0.0;
  double square = 0.0;
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < residuals.size(); ++i) {
    const LineResidual& a = residuals[i - 1];
    const LineResidual& b = residuals[i];
    if (!is_inlier(a, scale) || !is_inlier(b, scale)) continue;
    product += a.distance * b.distance / std::sqrt(a.var * b.var);
    square += 0.5 * (a.distance * a.distance / a.var + b.distance * b.distance / b.var);
    ++pairs;
  }
  if (pairs < 10 || square <= 0.0) return 1.0;
  // An estimate from n pairs is good to 1 / sqrt(n): a smaller one is no evidence.
  const double rho = std::min(product / square, 0.95);
  if (rho < 2.0 / std::sqrt(static_cast<double>(pairs))) return 1.0;
  return (1.0 + rho) / (1.0 - rho);
}

}  // namespace

bool is_inlier(const LineResidual& residual, double scale) {
  const double gate = std::max(kInlierFloor, kSigmas * scale * std::sqrt(residual.var));
  return std::abs(residual.distance) < std::min(gate, kFirstWidth);
}

LineResidual line_residual(const LineMap& map,
                           const Pose<Field, Robot>& X_FR,
                           const LinePoint& point) {
  const Eigen::Matrix2d R_FR = X_FR.rotation();
  const Eigen::Vector2d p_RL_F = R_FR * point.p_R.vector();
  const NearestLine nearest = map.nearest(X_FR.origin().vector() + p_RL_F);
  const Eigen::Vector2d& n = nearest.normal_F;
  const Eigen::Vector2d n_R = R_FR.transpose() * n;
  LineResidual result;
  result.distance = nearest.distance;
  result.jacobian = {n.x(), n.y(), n.dot(Eigen::Vector2d(-p_RL_F.y(), p_RL_F.x()))};
  result.var = n_R.dot(point.cov_R * n_R);
  return result;
}

void PostureFitter::look(const LineMap& map,
                         std::span<const LinePoint> points,
                         const Pose<Field, Robot>& X_FR) {
  residuals_.clear();
  for (const LinePoint& point : points) residuals_.push_back(line_residual(map, X_FR, point));
}

double PostureFitter::measure_scale(std::span<const LineResidual> residuals) {
  sorted_.clear();
  for (const LineResidual& r : residuals) {
    if (std::abs(r.distance) < kFirstWidth) {
      sorted_.push_back(std::abs(r.distance) / std::sqrt(r.var));
    }
  }
  if (sorted_.size() < 5) return 1.0;
  const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 2);
  std::nth_element(sorted_.begin(), middle, sorted_.end());
  const auto count = static_cast<double>(sorted_.size());
  const double measured = kMadToSigma * *middle;
  return std::sqrt((kPriorPoints + count * measured * measured) / (kPriorPoints + count));
}

bool PostureFitter::step(Pose<Field, Robot>& X_FR, double width, double scale) const {
  Eigen::Matrix3d info = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (const LineResidual& r : residuals_) {
    const double u = r.distance / width_of(r, width, scale);
    const double weight = 1.0 / ((1.0 + u * u) * (1.0 + u * u) * r.var);
    info += weight * r.jacobian * r.jacobian.transpose();
    gradient += weight * r.distance * r.jacobian;
  }
  // A little damping keeps an open direction where it is instead of throwing the robot off.
  info.diagonal() += Eigen::Vector3d::Constant(1.0);
  const Eigen::Vector3d change = info.ldlt().solve(-gradient);
  if (!change.allFinite()) return false;
  const double limit = std::min(1.0, 0.5 / std::max(change.head<2>().norm(), 1e-12));
  X_FR = {X_FR.x() + limit * change.x(),
          X_FR.y() + limit * change.y(),
          X_FR.theta() + std::clamp(limit * change.z(), -0.5, 0.5)};
  return change.head<2>().norm() > 1e-5 || std::abs(change.z()) > 1e-5;
}

void PostureFitter::judge(PostureFit& fit) {
  Eigen::Matrix3d info = Eigen::Matrix3d::Zero();
  double sum_square = 0.0;
  double sum_slope = 0.0;
  std::size_t inliers = 0;
  const auto count = static_cast<double>(residuals_.size());
  for (const LineResidual& r : residuals_) {
    const double c = width_of(r, 0.0, fit.scale);
    const double u2 = std::pow(r.distance / c, 2);
    // psi and its slope of the kernel, of residuals in units of the claimed sigma.
    const double psi = r.distance / std::pow(1.0 + u2, 2);
    sum_square += psi * psi / r.var;
    sum_slope += (1.0 - 3.0 * u2) / std::pow(1.0 + u2, 3);
    info += r.jacobian * r.jacobian.transpose() / r.var;
    if (is_inlier(r, fit.scale)) ++inliers;
    fit.support += 1.0 / (1.0 + std::pow(r.distance / kVoteWidth, 2));
  }
  fit.inlier_ratio = static_cast<double>(inliers) / count;
  if (sum_slope < 3.5) return;
  // Sandwich of the M-estimator, with the three degrees of freedom that the fit used up.
  const double mean_slope = sum_slope / count;
  const double measured = sum_square / ((count - 3.0) * mean_slope * mean_slope);
  const double variance = (count * measured + kClaimPoints) / (count + kClaimPoints);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(info);
  if (eigen.eigenvalues().minCoeff() <= 1e-9) return;
  const double inflation = correlation_inflation(residuals_, fit.scale);
  fit.cov = variance * inflation * info.inverse();
  fit.cov = 0.5 * (fit.cov + fit.cov.transpose()).eval();
  fit.observable = fit.cov.diagonal().maxCoeff() < kOpenSigma * kOpenSigma;
}

PostureFit PostureFitter::fit(const LineMap& map,
                              std::span<const LinePoint> points,
                              const Pose<Field, Robot>& start) {
  TEAMSIGHT_EXPECT(!points.empty());
  PostureFit fit;
  fit.X_FR = start;
  double width = kFirstWidth;
  for (int i = 0; i < kMaxSteps; ++i) {
    look(map, points, fit.X_FR);
    fit.scale = measure_scale(residuals_);
    const bool moved = step(fit.X_FR, width, fit.scale);
    if (!moved && width < kLastWidth) break;
    width *= kShrink;
  }
  look(map, points, fit.X_FR);
  fit.scale = measure_scale(residuals_);
  judge(fit);
  return fit;
}

}  // namespace teamsight::vision
