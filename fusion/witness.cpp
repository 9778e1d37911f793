// fusion/witness.cpp: see fusion/witness.hpp.
#include "fusion/witness.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "geometry/angle.hpp"

namespace teamsight::fusion {
namespace {

// Candidates that have nothing to do with a claim, per m^2: a handful within the robot's sight.
constexpr double kElsewhere = 0.05;
constexpr double kCandidateReach = 1.5;  // m: candidates further from a claim are not it

/// The frame as it would be if the robot stood at the mirror image.
CandidateList turned(const CandidateList& candidates, const Eigen::Vector2d& centre_F) {
  CandidateList result = candidates;
  for (Candidate& candidate : result) {
    candidate.measurement.p_F = 2.0 * centre_F - candidate.measurement.p_F;
    candidate.azimuth = wrap_angle(candidate.azimuth + std::numbers::pi);
  }
  return result;
}

/// Density of the likeliest candidate for the claim; 1/m^2.
double best_density(const Claim& claim, const CandidateList& candidates, double slack) {
  double best = 0.0;
  for (const Candidate& candidate : candidates) {
    const Eigen::Vector2d gap = candidate.measurement.p_F - claim.p_F;
    if (gap.norm() > kCandidateReach) continue;
    const Eigen::Matrix2d cov =
        claim.cov + candidate.measurement.cov_F + slack * slack * Eigen::Matrix2d::Identity();
    const double squared = gap.dot(cov.inverse() * gap);
    best = std::max(
        best, std::exp(-0.5 * squared) / (2.0 * std::numbers::pi * std::sqrt(cov.determinant())));
  }
  return best;
}

/// Whether something else that is claimed stands between.
bool is_behind_claims(const Claim& claim,
                      const ClaimList& claims,
                      const Eigen::Vector2d& observer_F,
                      double body) {
  const Shadow here = shadow_of(claim.p_F, body, observer_F);
  return std::any_of(claims.begin(), claims.end(), [&](const Claim& other) {
    if (other.is_ball) return false;
    const Shadow shadow = shadow_of(other.p_F, body, observer_F);
    return shadow.distance < here.distance - 2.0 * body &&
           std::abs(angle_difference(shadow.azimuth, here.azimuth)) < shadow.half_angle;
  });
}

/// That robots report an obstacle at this distance: the median of the eyes.
double usual_probability(const Eyes& eyes, double distance, const Parameters& parameters) {
  if (eyes.empty())
    return Eyesight{}.probability(distance, parameters.obstacle, parameters.eyesight);
  InlineList<double, kMaxRobotId> all;
  for (const Eyesight& one : eyes) {
    all.push_back(one.probability(distance, parameters.obstacle, parameters.eyesight));
  }
  double* const middle = all.begin() + (all.size() - 1) / 2;
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

/// That the robot's frame shows a claim if the robot stands where it says.
double shown(const Claim& claim,
             const Testimony& testimony,
             const ClaimList& claims,
             const Parameters& parameters) {
  if (claim.is_ball) {
    return detection_probability(
        claim.p_F, testimony.observer_F, testimony.obstacles, parameters.ball);
  }
  const double distance = (claim.p_F - testimony.observer_F).norm();
  const double probability = usual_probability(testimony.eyes, distance, parameters);
  if (probability == 0.0) return 0.0;
  const bool is_hidden =
      is_behind(claim.p_F, testimony.observer_F, testimony.obstacles) ||
      is_behind_claims(claim, claims, testimony.observer_F, parameters.robot_radius);
  return is_hidden ? 0.0 : probability;
}

/// Log-odds that the robot stands there rather than anywhere, by one claim.
double odds_by(const Claim& claim,
               const Testimony& testimony,
               const ClaimList& claims,
               const Parameters& parameters) {
  const double seen = shown(claim, testimony, claims, parameters);
  const CandidateList& candidates = claim.is_ball ? testimony.balls : testimony.obstacles;
  const double density = best_density(claim, candidates, parameters.trust.slack);
  // What cannot be expected is no evidence, unless it is found all the same.
  const double expected = density > kElsewhere ? std::max(seen, 0.3) : seen;
  const double odds = std::log(1.0 - expected + expected * density / kElsewhere);
  return std::clamp(odds, -parameters.trust.most_against, parameters.trust.most_for);
}

}  // namespace

EvidenceList weigh(const Testimony& testimony,
                   const ClaimList& claims,
                   const Eigen::Vector2d& centre_F,
                   const Parameters& parameters) {
  const CandidateList turned_balls = turned(testimony.balls, centre_F);
  const CandidateList turned_obstacles = turned(testimony.obstacles, centre_F);
  const Testimony other{testimony.robot,
                        2.0 * centre_F - testimony.observer_F,
                        turned_balls,
                        turned_obstacles,
                        testimony.eyes};
  std::array<PairEvidence, kMaxRobotId> by_robot{};
  for (const Claim& claim : claims) {
    const double here = odds_by(claim, testimony, claims, parameters);
    const double there = odds_by(claim, other, claims, parameters);
    if (here == 0.0 && there == 0.0) continue;
    const double share = 1.0 / std::max(1, std::popcount(claim.claimants));
    for (std::size_t i = 0; i < by_robot.size(); ++i) {
      if ((claim.claimants >> i & 1U) == 0) continue;
      by_robot[i].other = static_cast<RobotId>(i + 1);
      by_robot[i].agreement += share * here;
      by_robot[i].same_half += share * (here - there);
    }
  }
  EvidenceList evidence;
  for (const PairEvidence& pair : by_robot) {
    if (pair.other != kNobody && pair.other != testimony.robot) evidence.push_back(pair);
  }
  return evidence;
}

}  // namespace teamsight::fusion
