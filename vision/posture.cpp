// vision/posture.cpp: tracking first, then search; who of two mirror images it is.
#include "vision/posture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

#include "geometry/angle.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::vision {

namespace {

constexpr double kFirstWidth = 0.25;  // m, of the kernel: a prior may be that wrong
constexpr std::size_t kFewestPoints = 15;
constexpr double kTrackedSupport = 0.7;  // votes per point that make a search unnecessary
constexpr double kLostInliers = 0.45;    // below this share of inliers nothing is believed
constexpr double kLostSupport = 0.45;
constexpr double kRival = 0.92;   // of the best one's votes: fits alike
constexpr double kDecided = 2.2;  // log-odds: nine to one
constexpr double kCarried = 8.0;  // half of the squared distance (4 sigma) that ends a prior

// log(p exp(a) + (1 - p) exp(b) + exp(floor)) for a, b, floor <= 0.
double log_mixture(double p, double a, double b) {
  return std::log(p * std::exp(a) + (1.0 - p) * std::exp(b) + std::exp(-kCarried));
}

double log_density(const Pose<Field, Robot>& X_FR, const MotionPrior& prior) {
  Eigen::Vector3d gap = X_FR.vector() - prior.X_FR->vector();
  gap.z() = wrap_angle(gap.z());
  return -0.5 * squared_mahalanobis(gap, prior.cov);
}

bool is_good(const PostureFit& fit, std::size_t points) {
  return fit.observable && fit.inlier_ratio >= kLostInliers &&
         fit.support >= kLostSupport * static_cast<double>(points);
}

bool is_near(const PostureFit& fit, const MotionPrior& prior) {
  return log_density(fit.X_FR, prior) > -kCarried;
}

}  // namespace

double half_log_odds_from_prior(const Pose<Field, Robot>& X_FR,
                                const MotionPrior& prior,
                                const Point<Field>& centre) {
  if (!prior.X_FR) return 0.0;
  const double here = log_density(X_FR, prior);
  const double there = log_density(mirrored(X_FR, centre), prior);
  const double p = 1.0 / (1.0 + std::exp(-prior.half_log_odds));
  const double odds = log_mixture(p, here, there) - log_mixture(p, there, here);
  return std::clamp(odds, -kMaxHalfLogOdds, kMaxHalfLogOdds);
}

double half_log_odds_from_side(const Pose<Field, Robot>& X_FR,
                               double sigma_x,
                               StartSide side,
                               const Point<Field>& centre) {
  if (side == StartSide::kUnknown) return 0.0;
  constexpr double kSmallestSigma = 0.05;  // m; robots are not put down on a hair
  const double into_opponent_half = X_FR.x() - centre.x;
  const double z = into_opponent_half / std::max(sigma_x, kSmallestSigma) / std::numbers::sqrt2;
  const double towards = side == StartSide::kOpponentHalf ? z : -z;
  const double odds = std::log(std::erfc(-towards) / std::max(std::erfc(towards), 1e-300));
  return std::clamp(odds, -kMaxHalfLogOdds, kMaxHalfLogOdds);
}

PostureEstimator::PostureEstimator(const FieldModel& field,
                                   const HeadTilt& tilt,
                                   const SharedError& shared)
    : map_(field),
      tilt_(tilt),
      shared_(shared),
      symmetric_(is_half_turn_symmetric(field)),
      search_(map_, symmetric_) {}

PostureResult PostureEstimator::estimate(std::span<const LinePoint> points,
                                         const MotionPrior& prior) {
  PostureResult result;
  PostureEstimate& estimate = result.estimate;
  estimate.line_points = static_cast<std::uint16_t>(points.size());
  if (points.size() < kFewestPoints) return result;

  const bool has_prior = prior.X_FR && is_covariance(prior.cov);
  PostureFit best;
  bool rival = false;
  bool tracked = false;
  if (has_prior) {
    best = fitter_.fit(map_, points, {*prior.X_FR, kFirstWidth, tilt_});
    tracked = is_good(best, points.size()) && is_near(best, prior) &&
              best.support >= kTrackedSupport * static_cast<double>(points.size());
  }
  if (!tracked) {
    result.searched_globally = true;
    const auto found = search_.search(map_, points, fitter_, tilt_);
    best = found.front();
    rival = found.size() > 1 && is_good(found[1], points.size()) &&
            found[1].support > kRival * best.support;
  }
  estimate.inlier_ratio = best.inlier_ratio;
  if (!is_good(best, points.size())) return result;

  const Point<Field>& centre = map_.field().centre;
  estimate.half_log_odds =
      has_prior
          ? half_log_odds_from_prior(best.X_FR, prior, centre)
          : half_log_odds_from_side(best.X_FR, std::sqrt(best.cov(0, 0)), prior.start_side, centre);
  estimate.X_FR = best.X_FR;
  estimate.cov = best.cov + shared_part(best, shared_);
  result.scale = best.scale;
  result.tilt = best.tilt;
  if (!symmetric_) {
    estimate.half_log_odds = kMaxHalfLogOdds;
  } else if (estimate.half_log_odds < 0.0) {
    estimate.X_FR = mirrored(best.X_FR, centre);
    // Half a turn leaves the covariance of (x, y, theta) with both position signs flipped.
    estimate.cov.block<2, 1>(0, 2) *= -1.0;
    estimate.cov.block<1, 2>(2, 0) *= -1.0;
    estimate.half_log_odds *= -1.0;
  }
  estimate.status =
      rival || estimate.half_log_odds < kDecided ? PostureStatus::kAmbiguous : PostureStatus::kOk;
  return result;
}

}  // namespace teamsight::vision
