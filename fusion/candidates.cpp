// fusion/candidates.cpp: see fusion/candidates.hpp.
#include "fusion/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "fusion/measurement.hpp"

namespace teamsight::fusion {
namespace {

// Track keys of balls and obstacles of one observation must differ.
constexpr std::uint32_t kFirstObstacleIndex = 64;
// What half an obstacle's width errs by where nothing hides it; m.
constexpr double kSigmaAside = 0.05;
// Where along a ray that meets no carpet a ball may be; m.
constexpr double kAnyRange = 5.0;

bool is_on_carpet(const Eigen::Vector2d& p_F, const Setting& setting) {
  const FieldModel& field = setting.field;
  const double beyond = field.surround + setting.parameters.carpet_margin;
  return std::abs(p_F.x() - field.centre.x) <= 0.5 * field.length + beyond &&
         std::abs(p_F.y() - field.centre.y) <= 0.5 * field.width + beyond;
}

Candidate make_candidate(const PlanarMeasurement& measurement,
                         const Eigen::Vector2d& p_FR,
                         double radius) {
  Candidate candidate;
  const Eigen::Vector2d way = measurement.p_F - p_FR;
  candidate.measurement = measurement;
  candidate.radius = radius;
  candidate.azimuth = std::atan2(way.y(), way.x());
  candidate.distance = way.norm();
  candidate.half_angle = std::atan2(radius, candidate.distance);
  return candidate;
}

/// The posture as if its remembered errors were none, to see what else is uncertain.
PostureEstimate without_lasting(const Observation& observation, const TeamErrors& errors) {
  PostureEstimate posture = observation.posture;
  posture.cov = errors.fresh(errors.place_of(observation.id.robot), posture);
  return posture;
}

/// Somewhere along a ray that goes up, or meets the floor far outside.
PlanarMeasurement anywhere_along(const BallRay& ray, const PostureEstimate& posture) {
  const Eigen::Vector2d way = ray.ray_R.direction.head<2>().normalized() * kAnyRange;
  PlanarMeasurement measurement;
  measurement.p_F = (posture.X_FR * Point<Robot>::from(way)).vector();
  measurement.cov_F = kAnyRange * kAnyRange * Eigen::Matrix2d::Identity();
  return measurement;
}

/// Whether a track may begin with a ball that is known so well.
bool may_begin(const PlanarMeasurement& ball, const Setting& setting) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(ball.cov_F, Eigen::EigenvaluesOnly);
  return std::sqrt(axes.eigenvalues().maxCoeff()) <= setting.parameters.ball.max_sigma_at_birth;
}

/// Where the ray meets the floor, on the carpet.
std::optional<PlanarMeasurement> floor_place(const BallRay& ray,
                                             const PostureEstimate& posture,
                                             const Setting& setting) {
  const auto met = measure_ball(ray, posture, setting.parameters.ball_radius);
  return met && is_on_carpet(met->p_F, setting) ? met : std::nullopt;
}

/// Where the ball is by its size, if a track may begin there: over the carpet, not higher than
/// balls fly, and near enough.
std::optional<BallInSpace> ball_in_air(const BallRay& ray,
                                       const PostureEstimate& posture,
                                       const Setting& setting) {
  constexpr double kHighest = 4.0;  // m
  const double radius = setting.parameters.ball_radius;
  const auto ball = ball_by_size(ray, radius);
  if (!ball || ball->p_R.z() < radius || ball->p_R.z() > kHighest) return std::nullopt;
  const PlanarMeasurement place = below(*ball, posture);
  return is_on_carpet(place.p_F, setting) && may_begin(place, setting) ? ball : std::nullopt;
}

CandidateList ball_candidates(const Observation& observation,
                              const TeamErrors& errors,
                              const Setting& setting) {
  CandidateList candidates;
  const PostureEstimate fresh = without_lasting(observation, errors);
  const double radius = setting.parameters.ball_radius;
  const Eigen::Vector2d p_FR = observation.posture.X_FR.origin().vector();
  for (std::uint32_t index = 0; index < observation.balls.size(); ++index) {
    const BallRay& ray = observation.balls[index];
    if (ray.confidence < setting.parameters.ball.min_confidence || candidates.is_full()) continue;
    if (ray.ray_R.direction.head<2>().norm() < 1e-9) continue;
    const auto met = floor_place(ray, observation.posture, setting);
    const bool is_sure = met && may_begin(*met, setting);
    const auto in_air = is_sure ? std::nullopt : ball_in_air(ray, observation.posture, setting);
    Candidate candidate;
    if (in_air) {
      candidate = make_candidate(below(*in_air, observation.posture), p_FR, radius);
      candidate.cov_own = below(*in_air, fresh).cov_F;
      candidate.is_high = true;
      candidate.doubt = setting.parameters.newcomer.most_doubt;
    } else if (met) {
      candidate = make_candidate(*met, p_FR, radius);
      candidate.cov_own = measure_ball(ray, fresh, radius)->cov_F;
    } else {
      candidate = make_candidate(anywhere_along(ray, observation.posture), p_FR, radius);
      candidate.may_begin = false;
    }
    candidate.confidence = ray.confidence;
    candidate.key = track_key(observation.id, index);
    candidate.index = index;
    candidates.push_back(candidate);
  }
  return candidates;
}

/// How wide a whole robot seems whose foot is that far away: its edges lie behind its foot; m.
double apparent_width(double distance, double radius) {
  return 2.0 * radius * std::sqrt(distance / (distance + 2.0 * radius));
}

/// A sighting with what its width says of its axis: narrower than a robot, part of it is hidden;
/// wider, there are two side by side. By what is missing or too much the axis may lie aside, and
/// where that is more than it errs by anyway, it is as unsure as that.
ObstacleSighting with_unsure_axis(const ObstacleSighting& sighting, double radius) {
  ObstacleSighting unsure = sighting;
  const Eigen::Vector2d foot = sighting.p_RO.vector();
  const double distance = foot.norm();
  if (sighting.width <= 0.0 || distance < 1e-6) return unsure;
  const double aside = 0.5 * (sighting.width - apparent_width(distance, radius));
  const Eigen::Vector2d across = Eigen::Vector2d(-foot.y(), foot.x()) / distance;
  const double more =
      aside * aside - across.dot(sighting.cov_R * across) - kSigmaAside * kSigmaAside;
  if (more > 0.0) unsure.cov_R += more * across * across.transpose();
  return unsure;
}

CandidateList obstacle_candidates(const Observation& observation,
                                  const TeamErrors& errors,
                                  const Setting& setting) {
  CandidateList candidates;
  const PostureEstimate fresh = without_lasting(observation, errors);
  for (std::uint32_t index = 0; index < observation.obstacles.size(); ++index) {
    const double robot_radius = setting.parameters.robot_radius;
    const ObstacleSighting sighting = with_unsure_axis(observation.obstacles[index], robot_radius);
    if (sighting.confidence < setting.parameters.obstacle.min_confidence) continue;
    if (candidates.is_full()) break;
    const double radius = radius_of(sighting, robot_radius);
    const auto measurement = measure_obstacle(sighting, observation.posture, robot_radius);
    if (!is_on_carpet(measurement.p_F, setting)) continue;
    Candidate candidate =
        make_candidate(measurement, observation.posture.X_FR.origin().vector(), radius);
    candidate.cov_own = measure_obstacle(sighting, fresh, robot_radius).cov_F;
    candidate.confidence = sighting.confidence;
    candidate.key = track_key(observation.id, kFirstObstacleIndex + index);
    candidate.index = index;
    candidates.push_back(candidate);
  }
  return candidates;
}

}  // namespace

Sighted sighted_in(const Observation& observation,
                   const TeamErrors& errors,
                   const Setting& setting) {
  return {ball_candidates(observation, errors, setting),
          obstacle_candidates(observation, errors, setting)};
}

}  // namespace teamsight::fusion
