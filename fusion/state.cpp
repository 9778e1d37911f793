// fusion/state.cpp: see fusion/state.hpp.
#include "fusion/state.hpp"

#include <algorithm>
#include <cmath>

#include "fusion/assignment.hpp"
#include "fusion/measurement.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::fusion {
namespace {

// Track keys of balls and obstacles of one observation must differ.
constexpr std::uint32_t kFirstObstacleIndex = 64;

Teammate& find_or_add(State& state, RobotId robot) {
  for (Teammate& teammate : state.teammates) {
    if (teammate.robot == robot) return teammate;
  }
  Teammate fresh;
  fresh.robot = robot;
  state.teammates.push_back(fresh);
  return state.teammates[state.teammates.size() - 1];
}

bool is_believable_place(const Eigen::Vector2d& p_F, const Setting& setting) {
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

CandidateList ball_candidates(const Observation& observation, const Setting& setting) {
  CandidateList candidates;
  std::uint32_t index = 0;
  for (const BallRay& ray : observation.balls) {
    const std::uint32_t key = track_key(observation.id, index++);
    if (ray.confidence < setting.parameters.ball.min_confidence || candidates.is_full()) continue;
    const auto measurement = measure_ball(ray, observation.posture, setting.parameters.ball_radius);
    if (!measurement || !is_believable_place(measurement->p_F, setting)) continue;
    Candidate candidate = make_candidate(
        *measurement, observation.posture.X_FR.origin().vector(), setting.parameters.ball_radius);
    candidate.confidence = ray.confidence;
    candidate.key = key;
    candidates.push_back(candidate);
  }
  return candidates;
}

CandidateList obstacle_candidates(const Observation& observation, const Setting& setting) {
  CandidateList candidates;
  std::uint32_t index = kFirstObstacleIndex;
  for (const ObstacleSighting& sighting : observation.obstacles) {
    const std::uint32_t key = track_key(observation.id, index++);
    if (sighting.confidence < setting.parameters.obstacle.min_confidence) continue;
    if (candidates.is_full()) break;
    const double radius = radius_of(sighting, setting.parameters.robot_radius);
    const auto measurement = measure_obstacle(sighting, observation.posture, radius);
    if (!is_believable_place(measurement.p_F, setting)) continue;
    Candidate candidate =
        make_candidate(measurement, observation.posture.X_FR.origin().vector(), radius);
    candidate.confidence = sighting.confidence;
    candidate.key = key;
    candidates.push_back(candidate);
  }
  return candidates;
}

bool is_to_be_sighted(const Teammate& teammate,
                      const Observation& observation,
                      const TeammateParameters& parameters) {
  return teammate.robot != observation.id.robot && teammate.posture.time != kNever &&
         observation.exposure - teammate.seen <= parameters.forget_age &&
         is_resolved(teammate.status, teammate.half_log_odds, parameters);
}

/// Cost of taking a sighted thing for a teammate's body, carried to the same instant.
double body_cost(const PlanarMeasurement& seen,
                 const CarriedPosture& carried,
                 const Parameters& parameters) {
  const double var_body = parameters.teammate.sigma_body * parameters.teammate.sigma_body;
  const Eigen::Matrix2d cov =
      carried.cov.topLeftCorner<2, 2>() + seen.cov_F + var_body * Eigen::Matrix2d::Identity();
  const double distance = squared_mahalanobis(seen.p_F - carried.X_FR.origin().vector(), cov);
  if (distance <= chi_square_gate(2, parameters.obstacle.gate_probability)) return distance;
  return kForbidden;
}

/// The candidates that are no teammates.
CandidateList without_teammates(const CandidateList& candidates,
                                const State& state,
                                const Observation& observation,
                                const Parameters& parameters) {
  CostMatrix cost(static_cast<Eigen::Index>(candidates.size()),
                  static_cast<Eigen::Index>(state.teammates.size()));
  cost.setConstant(kForbidden);
  for (std::size_t column = 0; column < state.teammates.size(); ++column) {
    const Teammate& teammate = state.teammates[column];
    if (!is_to_be_sighted(teammate, observation, parameters.teammate)) continue;
    const auto carried = carried_to(teammate.posture, observation.exposure, parameters.teammate);
    for (std::size_t row = 0; row < candidates.size(); ++row) {
      cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          body_cost(candidates[row].measurement, carried, parameters);
    }
  }
  constexpr double kAlonePrice = 1e4;  // dearer than any pair within the gate
  const Assignment assignment = assign(cost, kAlonePrice);
  CandidateList others;
  for (std::size_t row = 0; row < candidates.size(); ++row) {
    if (assignment[row] == kUnassigned) others.push_back(candidates[row]);
  }
  return others;
}

}  // namespace

void advance(State& state, const Observation& observation, const Setting& setting) {
  const Parameters& parameters = setting.parameters;
  Teammate& observer = find_or_add(state, observation.id.robot);
  take_frame(
      observer, observation.id, observation.posture, observation.exposure, parameters.teammate);
  if (std::any_of(observation.balls.begin(), observation.balls.end(), [&](const BallRay& ray) {
        return ray.confidence >= parameters.ball.min_confidence;
      })) {
    observer.ball_seen = observation.exposure;
  }
  if (quarantine_of(observer, observation.exposure, parameters.teammate) != Quarantine::kNone) {
    ++observer.rejected_posture;
    return;
  }
  const CandidateList balls = ball_candidates(observation, setting);
  const CandidateList sighted = obstacle_candidates(observation, setting);
  const CandidateList obstacles = without_teammates(sighted, state, observation, parameters);
  const Glance glance{observation.id.robot,
                      observation.exposure,
                      observation.sigma_exposure,
                      observation.posture.X_FR.origin().vector()};
  const std::uint32_t unused =
      take_in(state.balls, balls, glance, sighted, parameters.ball) +
      take_in(state.obstacles, obstacles, glance, sighted, parameters.obstacle);
  const auto offered = observation.balls.size() + observation.obstacles.size();
  const auto left_out = offered - balls.size() - sighted.size() + unused;
  observer.rejected_gate += static_cast<std::uint32_t>(left_out);
  observer.accepted += static_cast<std::uint32_t>(offered - left_out);
}

}  // namespace teamsight::fusion
