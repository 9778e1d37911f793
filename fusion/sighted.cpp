// fusion/sighted.cpp: see fusion/sighted.hpp.
#include "fusion/sighted.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "fusion/assignment.hpp"
#include "fusion/measurement.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::fusion {
namespace {

constexpr double kFarthestMistake = 5.0;  // m

/// A teammate's body, where the others should see it.
struct Body {
  RobotId robot{kNobody};
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};              ///< m
  Eigen::Matrix2d cov{Eigen::Matrix2d::Identity()};          ///< of p_F; m^2
  Eigen::Matrix2d cov_carried{Eigen::Matrix2d::Identity()};  ///< without its remembered errors'
  bool is_turned{false};  ///< it says that it is at the mirror image
};

/// @return nothing if it is not known where it is
std::optional<Body> body_of(const Teammate& teammate,
                            RobotId observer,
                            HostTime exposure,
                            const State& state,
                            const Parameters& parameters) {
  const TeammateParameters& mates = parameters.teammate;
  if (teammate.robot == observer || teammate.posture.time == kNever ||
      exposure - teammate.seen > mates.forget_age ||
      !is_resolved(teammate.status, teammate.half_log_odds, mates)) {
    return std::nullopt;
  }
  const Quarantine verdict = state.trust.verdict(teammate.robot, exposure, parameters.trust);
  if (verdict == Quarantine::kKidnapped) return std::nullopt;
  const CarriedPosture carried = carried_to(teammate.posture, exposure, mates);
  Body body;
  body.robot = teammate.robot;
  body.is_turned = verdict == Quarantine::kMirrored;
  body.p_F = (body.is_turned ? mirrored(carried.X_FR) : carried.X_FR).origin().vector();
  body.cov = carried.cov.topLeftCorner<2, 2>();
  const Eigen::Matrix3d fresh =
      state.errors.fresh(state.errors.place_of(teammate.robot), teammate.posture.last);
  body.cov_carried = (carried.cov_since + fresh).topLeftCorner<2, 2>();
  return body;
}

/// Where a robot stands by what is known of its error.
Eigen::Vector2d without_error(const Eigen::Vector2d& p_F,
                              ErrorPlace place,
                              const TeamErrors& errors) {
  if (place == kNoPlace) return p_F;
  return p_F - errors.mean(place).head<2>();
}

/// The residual of a sighted teammate: where it was seen, minus where it says that it is. Linear
/// about what is known of the observer's heading, which may be off by more than a small angle.
TeamErrors::Residual residual_of(const Candidate& seen,
                                 const Body& body,
                                 const Glance& glance,
                                 const State& state,
                                 const Parameters& parameters) {
  TeamErrors::Residual residual;
  const double aside = parameters.teammate.sigma_body;
  residual.observer = state.errors.place_of(glance.robot);
  const double turned =
      residual.observer == kNoPlace ? 0.0 : state.errors.mean(residual.observer)(2);
  const Eigen::Vector2d said = seen.measurement.p_F - glance.observer();
  const Eigen::Vector2d way = Eigen::Rotation2Dd(-turned) * said;
  // Sloped by where it stands: by where it was seen, what a look errs by would weigh the look, and
  // all robots would seem to see too far.
  residual.watched = state.errors.place_of(body.robot);
  residual.slope_observer =
      place_slope(without_error(body.p_F, residual.watched, state.errors) -
                  without_error(glance.observer(), residual.observer, state.errors));
  residual.value = glance.observer() + way - body.p_F + residual.slope_observer.col(2) * turned;
  residual.slope_watched << -Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Zero();
  residual.cov = seen.cov_own + (residual.watched == kNoPlace ? body.cov : body.cov_carried) +
                 aside * aside * Eigen::Matrix2d::Identity();
  return residual;
}

/// Whether a sighted thing fits an obstacle that more than one robot has vouched for.
bool fits_an_obstacle(const Candidate& seen,
                      HostTime exposure,
                      const State& state,
                      const TrackParameters& parameters) {
  return std::ranges::any_of(state.obstacles, [&](const Track& track) {
    if (!track.book.is_confirmed || log_odds_of(track.book) <= parameters.most_vote) return false;
    const PlanarMoments moments = moments_at(track, exposure, parameters);
    const Eigen::Vector2d gap = seen.measurement.p_F - moments.mean.head<2>();
    const Eigen::Matrix2d cov = seen.measurement.cov_F + moments.cov.topLeftCorner<2, 2>();
    return gap.dot(cov.inverse() * gap) <= chi_square_gate(2, parameters.gate_probability);
  });
}

/// Density of seeing another body that far from a teammate's: where robots crowd they stand side by
/// side, but never nearer than they are wide; 1/m^2.
///
/// @param sigma  per axis, of what is seen; m
double density_of_others(double distance, double sigma, const Parameters& parameters) {
  const double beyond = distance - 2.0 * parameters.robot_radius;
  return 0.5 * parameters.teammate.other_density *
         std::erfc(-beyond / (std::numbers::sqrt2 * sigma));
}

/// Cost of taking a sighted thing for a teammate's body.
///
/// @param is_obstacle  it fits one that is known: being near to the teammate is not enough then
double body_cost(const TeamErrors::Residual& residual,
                 bool is_obstacle,
                 const State& state,
                 const Parameters& parameters) {
  const TeamErrors::Lesson lesson = state.errors.lesson_of(residual);
  if (lesson.surprise.norm() > kFarthestMistake) return kForbidden;
  const double squared = lesson.surprise.dot(lesson.inverse * lesson.surprise);
  const bool is_within = squared <= chi_square_gate(2, parameters.obstacle.gate_probability);
  const bool is_touching = !is_obstacle && lesson.surprise.norm() < parameters.teammate.body_reach;
  if (is_within || is_touching) return squared;
  return kForbidden;
}

/// Whether what touches a teammate's body is rather another one beside it.
bool is_beside(const TeamErrors::Residual& residual,
               const State& state,
               const Parameters& parameters) {
  const TeamErrors::Lesson lesson = state.errors.lesson_of(residual);
  const double squared = lesson.surprise.dot(lesson.inverse * lesson.surprise);
  if (squared <= chi_square_gate(2, parameters.obstacle.gate_probability)) return false;
  const double sigma = std::sqrt(0.5 * lesson.inverse.inverse().trace());
  return tail_density(squared, lesson.inverse) <=
         density_of_others(lesson.surprise.norm(), sigma, parameters);
}

/// Tells the book of biases how far from where it says the teammate was seen.
void note_gap(AsideBook& book,
              const Candidate& seen,
              const Body& body,
              const Glance& glance,
              const Parameters& parameters) {
  const double aside = parameters.teammate.sigma_body;
  MateSighting sighting;
  sighting.observer = glance.robot;
  sighting.watched = body.robot;
  sighting.exposure = glance.exposure;
  sighting.gap = seen.measurement.p_F - body.p_F;
  sighting.cov = seen.measurement.cov_F + body.cov + aside * aside * Eigen::Matrix2d::Identity();
  book.take(sighting, parameters);
}

/// Every track that was seen with the errors learns with them.
void learn(State& state, const TeamErrors::Lesson& lesson) {
  for (BallTrack& ball : state.balls) {
    for (BallBelief& belief : ball.beliefs) belief.state.learn(lesson);
  }
  for (Track& obstacle : state.obstacles) obstacle.state.learn(lesson);
  state.errors.learn(lesson);
}

Glance glance_of(const Observation& observation) {
  return {
      observation.id.robot, observation.exposure, observation.sigma_exposure, observation.posture};
}

}  // namespace

MateSightings find_teammates(const CandidateList& candidates,
                             const State& state,
                             const Observation& observation,
                             const Parameters& parameters) {
  CostMatrix cost(static_cast<Eigen::Index>(candidates.size()),
                  static_cast<Eigen::Index>(state.teammates.size()));
  cost.setConstant(kForbidden);
  const Glance glance = glance_of(observation);
  std::array<bool, kMaxCandidates> is_obstacle{};
  for (std::size_t row = 0; row < candidates.size(); ++row) {
    is_obstacle[row] =
        fits_an_obstacle(candidates[row], observation.exposure, state, parameters.obstacle);
  }
  for (std::size_t column = 0; column < state.teammates.size(); ++column) {
    const Teammate& teammate = state.teammates[column];
    const auto body =
        body_of(teammate, observation.id.robot, observation.exposure, state, parameters);
    if (!body) continue;
    for (std::size_t row = 0; row < candidates.size(); ++row) {
      const auto residual = residual_of(candidates[row], *body, glance, state, parameters);
      cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          body_cost(residual, is_obstacle[row], state, parameters);
    }
  }
  constexpr double kAlonePrice = 1e4;  // dearer than any pair within the gate
  const Assignment assignment = assign(cost, kAlonePrice);
  MateSightings mates;
  mates.mate_of.fill(kUnassigned);
  mates.beside.fill(kUnassigned);
  for (std::size_t row = 0; row < candidates.size(); ++row) {
    if (assignment[row] == kUnassigned) continue;
    const Teammate& mate = state.teammates[static_cast<std::size_t>(assignment[row])];
    const auto body = body_of(mate, glance.robot, glance.exposure, state, parameters);
    const auto residual = residual_of(candidates[row], *body, glance, state, parameters);
    auto& places = is_beside(residual, state, parameters) ? mates.beside : mates.mate_of;
    places[row] = assignment[row];
  }
  return mates;
}

void learn_from_teammates(State& state,
                          const CandidateList& candidates,
                          const MateSightings& mates,
                          const Glance& glance,
                          const Parameters& parameters) {
  for (std::size_t row = 0; row < candidates.size(); ++row) {
    const bool is_mate = mates.mate_of[row] != kUnassigned;
    const int mate = is_mate ? mates.mate_of[row] : mates.beside[row];
    if (mate == kUnassigned) continue;
    const Teammate& teammate = state.teammates[static_cast<std::size_t>(mate)];
    const auto body = body_of(teammate, glance.robot, glance.exposure, state, parameters);
    if (!body || body->is_turned) continue;
    note_gap(state.aside, candidates[row], *body, glance, parameters);
    if (!is_mate) continue;
    TeamErrors::Residual residual = residual_of(candidates[row], *body, glance, state, parameters);
    TeamErrors::Lesson lesson = state.errors.lesson_of(residual);
    const double squared = lesson.surprise.dot(lesson.inverse * lesson.surprise);
    const double other = parameters.teammate.other_density;
    residual.cov *= tail_factor(squared, 2) * (1.0 + other / tail_density(squared, lesson.inverse));
    lesson = state.errors.lesson_of(residual);
    learn(state, lesson);
  }
}

ClaimList claims_of_others(const State& state,
                           RobotId robot,
                           HostTime exposure,
                           const Parameters& parameters) {
  ClaimList claims;
  const TrustParameters& trust = parameters.trust;
  const auto others = [&](const TrackBook& book) {
    const RobotMask supporters = robots_within(book.supported, exposure, trust.fresh);
    return static_cast<RobotMask>(supporters & ~robot_bit(robot));
  };
  for (const Teammate& teammate : state.teammates) {
    if (claims.is_full() || teammate.robot == robot || teammate.posture.time == kNever) continue;
    if (exposure - teammate.seen > trust.fresh ||
        !is_resolved(teammate.status, teammate.half_log_odds, parameters.teammate)) {
      continue;
    }
    const auto carried = carried_to(teammate.posture, exposure, parameters.teammate);
    claims.push_back({carried.X_FR.origin().vector(),
                      carried.cov.topLeftCorner<2, 2>(),
                      robot_bit(teammate.robot),
                      false});
  }
  for (const BallTrack& track : state.balls) {
    const RobotMask claimants = others(track.book);
    if (claims.is_full() || !track.book.is_confirmed || claimants == 0) continue;
    const BallMoments moments = moments_at(track, exposure, parameters.ball_motion);
    claims.push_back({moments.mean.head<2>(), moments.cov.topLeftCorner<2, 2>(), claimants, true});
  }
  for (const Track& track : state.obstacles) {
    const RobotMask claimants = others(track.book);
    if (claims.is_full() || !track.book.is_confirmed || claimants == 0) continue;
    const PlanarMoments moments = moments_at(track, exposure, parameters.obstacle);
    claims.push_back({moments.mean.head<2>(), moments.cov.topLeftCorner<2, 2>(), claimants, false});
  }
  return claims;
}

}  // namespace teamsight::fusion
