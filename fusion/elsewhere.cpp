// fusion/elsewhere.cpp: see fusion/elsewhere.hpp.
#include "fusion/elsewhere.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "geometry/angle.hpp"

namespace teamsight::fusion {
namespace {

constexpr double kElsewhere = 0.05;   // per m^2: candidates that have nothing to do with a claim
constexpr double kShown = 0.8;        // share of what a robot sees that others claim as well
constexpr double kReach = 1.0;        // m: candidates further from a claim are not it
constexpr double kLeastPair = 1.0;    // m: things nearer to each other tell no direction
constexpr double kPairSlack = 0.4;    // m: two pairs are as far apart
constexpr double kNear = 1.0;         // m
constexpr double kSameHeading = 0.3;  // rad
// What a free posture costs: the volume that a good fit leaves (0.15 m, 0.15 m, 0.05 rad) over that
// of a field of 18 by 12 m.
const double kPrice = std::log(18.0 * 12.0 * 2.0 * std::numbers::pi /
                               (std::pow(2.0 * std::numbers::pi, 1.5) * 0.15 * 0.15 * 0.05));

/// A rigid motion of what a frame shows.
struct Motion {
  Eigen::Rotation2Dd turn{0.0};
  Eigen::Vector2d from{Eigen::Vector2d::Zero()};
  Eigen::Vector2d to{Eigen::Vector2d::Zero()};

  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& p_F) const {
    return to + turn * (p_F - from);
  }
};

struct Fit {
  double odds{0.0};
  RobotMask claimants{0};
};

/// How what the frame shows fits the claims once it is moved.
Fit fit_of(const CandidateList& candidates,
           const ClaimList& claims,
           const Motion& motion,
           const TrustParameters& parameters) {
  Fit fit;
  for (const Candidate& candidate : candidates) {
    const Eigen::Vector2d p_F = motion * candidate.measurement.p_F;
    double density = 0.0;
    RobotMask claimants = 0;
    for (const Claim& claim : claims) {
      const Eigen::Vector2d gap = claim.p_F - p_F;
      if (claim.is_ball || gap.squaredNorm() > kReach * kReach) continue;
      const double var = 0.5 * (claim.cov + candidate.measurement.cov_F).trace() +
                         parameters.slack * parameters.slack;
      const double here = std::exp(-0.5 * gap.squaredNorm() / var) / (2.0 * std::numbers::pi * var);
      if (here <= density) continue;
      density = here;
      claimants = claim.claimants;
    }
    fit.odds +=
        std::min(std::log(1.0 - kShown + kShown * density / kElsewhere), parameters.most_for);
    if (density > kElsewhere) fit.claimants |= claimants;
  }
  return fit;
}

/// Whether the moved posture is the one that the robot says, or its mirror image.
bool is_known_place(const Motion& motion,
                    const Eigen::Vector2d& observer_F,
                    const Eigen::Vector2d& centre_F) {
  const Eigen::Vector2d moved = motion * observer_F;
  const double turn = std::abs(wrap_angle(motion.turn.angle()));
  const bool is_here = (moved - observer_F).norm() < kNear && turn < kSameHeading;
  const bool is_mirrored = (moved - 2.0 * centre_F + observer_F).norm() < 2.0 * kNear &&
                           turn > std::numbers::pi - 2.0 * kSameHeading;
  return is_here || is_mirrored;
}

/// The motion that lays a pair of sighted things upon a pair of claims; nothing if they are not as
/// far apart.
std::optional<Motion> motion_of(const std::array<Eigen::Vector2d, 2>& seen,
                                const std::array<Eigen::Vector2d, 2>& claimed) {
  const Eigen::Vector2d way = seen[1] - seen[0];
  const Eigen::Vector2d other = claimed[1] - claimed[0];
  if (std::abs(other.norm() - way.norm()) > kPairSlack) return std::nullopt;
  const double turn = std::atan2(other.y(), other.x()) - std::atan2(way.y(), way.x());
  return Motion{
      Eigen::Rotation2Dd(turn), 0.5 * (seen[0] + seen[1]), 0.5 * (claimed[0] + claimed[1])};
}

/// Log-odds of the posture in which this pair of sighted things lies best upon two claims.
double best_for_pair(const std::array<Eigen::Vector2d, 2>& seen,
                     const Testimony& testimony,
                     const ClaimList& claims,
                     const Eigen::Vector2d& centre_F,
                     const TrustParameters& parameters) {
  double best = 0.0;
  for (const Claim& first : claims) {
    for (const Claim& second : claims) {
      if (&first == &second || first.is_ball || second.is_ball) continue;
      const auto motion = motion_of(seen, {first.p_F, second.p_F});
      if (!motion || is_known_place(*motion, testimony.observer_F, centre_F)) continue;
      const Fit fit = fit_of(testimony.obstacles, claims, *motion, parameters);
      if (std::popcount(fit.claimants) >= 2) best = std::max(best, fit.odds);
    }
  }
  return best;
}

}  // namespace

double log_odds_elsewhere(const Testimony& testimony,
                          const ClaimList& claims,
                          const Eigen::Vector2d& centre_F,
                          const TrustParameters& parameters) {
  const CandidateList& seen = testimony.obstacles;
  const double here = fit_of(seen, claims, Motion{}, parameters).odds;
  const double price = here + kPrice;
  // However well another posture explains it, it would not pay.
  if (parameters.most_for * static_cast<double>(seen.size()) <= price) return 0.0;
  double best = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t j = i + 1; j < seen.size(); ++j) {
      const std::array<Eigen::Vector2d, 2> pair{seen[i].measurement.p_F, seen[j].measurement.p_F};
      if ((pair[1] - pair[0]).norm() < kLeastPair) continue;
      best = std::max(best, best_for_pair(pair, testimony, claims, centre_F, parameters));
    }
  }
  return std::max(0.0, best - price);
}

}  // namespace teamsight::fusion
