// fusion/state.cpp: see fusion/state.hpp.
#include "fusion/state.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "fusion/assignment.hpp"
#include "fusion/elsewhere.hpp"
#include "fusion/sight.hpp"
#include "fusion/sighted.hpp"
#include "fusion/witness.hpp"

namespace teamsight::fusion {
namespace {

Teammate& find_or_add(State& state, RobotId robot) {
  for (Teammate& teammate : state.teammates) {
    if (teammate.robot == robot) return teammate;
  }
  Teammate fresh;
  fresh.robot = robot;
  state.teammates.push_back(fresh);
  return state.teammates[state.teammates.size() - 1];
}

bool sees_ball(const Observation& observation, const Parameters& parameters) {
  return std::any_of(observation.balls.begin(), observation.balls.end(), [&](const BallRay& ray) {
    return ray.confidence >= parameters.ball.min_confidence;
  });
}

/// What the step from its last posture to this one means for what the others say about it.
void note_step(State& state, RobotId robot, PostureStep step, HostTime exposure) {
  switch (step) {
    case PostureStep::kSteady:
    case PostureStep::kSmallJump:
      return;
    case PostureStep::kTurnedOver:
      state.aside.forget(robot);
      return state.trust.turn_over(robot);
    case PostureStep::kJump:
      state.aside.forget(robot);
      state.trust.forget(robot);
      return state.trust.hold(robot, exposure);
    case PostureStep::kNewProcess:
      state.aside.forget(robot);
      return state.trust.forget(robot);
  }
}

/// Carries the robot's errors on, and whatever is correlated with them.
void note_errors(State& state,
                 const Observation& observation,
                 PostureStep step,
                 const Setting& setting) {
  if (observation.posture.status == PostureStatus::kLost) return;
  const RobotId robot = observation.id.robot;
  const double sigma_bias = state.aside.is_aside(robot) ? setting.parameters.trust.sigma_bias : 0.0;
  const ErrorMatrix keep = state.errors.report(
      robot, observation.posture, observation.exposure, {step != PostureStep::kSteady, sigma_bias});
  const ErrorPlace place = state.errors.place_of(robot);
  for (BallTrack& ball : state.balls) {
    for (BallBelief& belief : ball.beliefs) belief.state.follow(place, keep);
  }
  for (Track& obstacle : state.obstacles) obstacle.state.follow(place, keep);
}

/// Squared offset of a robot's posture as the others see it, in standard deviations.
double offset_of(const State& state, const Observation& observation, const Parameters& parameters) {
  const ErrorPlace place = state.errors.place_of(observation.id.robot);
  if (place == kNoPlace) return 0.0;
  const Eigen::Vector2d offset = state.errors.mean(place).head<2>();
  const double slack = parameters.teammate.sigma_body;
  const Eigen::Matrix2d cov =
      observation.posture.cov.topLeftCorner<2, 2>() + slack * slack * Eigen::Matrix2d::Identity();
  return offset.dot(cov.llt().solve(offset));
}

/// Whether it says that it stands beyond the carpet, by more than it may err.
bool is_off_carpet(const PostureEstimate& posture, const Setting& setting) {
  const Carpet carpet = Carpet::of(setting.field, setting.parameters.carpet_margin);
  const Eigen::Array2d aside = (posture.X_FR.origin().vector() - carpet.centre_F).array().abs();
  const Eigen::Array2d sigma = posture.cov.topLeftCorner<2, 2>().diagonal().array().sqrt();
  constexpr double kSure = 3.0;  // standard deviations
  return (aside > 0.5 * carpet.size.array() + kSure * sigma).any();
}

/// Weighs the frame against what the others say, now and then.
void gather_evidence(State& state,
                     const Observation& observation,
                     const Sighted& sighted,
                     const Setting& setting) {
  const TrustParameters& parameters = setting.parameters.trust;
  const RobotId robot = observation.id.robot;
  if (!state.trust.is_due(robot, observation.exposure, parameters)) return;
  const ClaimList claims = claims_of_others(state, robot, observation.exposure, setting.parameters);
  Eyes eyes;
  for (const Teammate& mate : state.teammates) {
    if (mate.robot != robot) eyes.push_back(mate.eyes);
  }
  const Testimony testimony{
      robot, observation.posture.X_FR.origin().vector(), sighted.balls, sighted.obstacles, eyes};
  const Eigen::Vector2d centre_F = setting.field.centre.vector();
  state.trust.begin_look(robot, observation.exposure, parameters);
  state.trust.note(robot,
                   observation.exposure,
                   observation.posture.half_log_odds,
                   offset_of(state, observation, setting.parameters));
  for (const PairEvidence& pair : weigh(testimony, claims, centre_F, setting.parameters)) {
    state.trust.add(robot, pair, parameters);
  }
  state.trust.note_elsewhere(robot,
                             observation.exposure,
                             log_odds_elsewhere(testimony, claims, centre_F, parameters),
                             parameters);
  state.trust.judge(observation.exposure, parameters);
  state.aside.judge(observation.exposure, parameters);
  for (const Teammate& mate : state.teammates) {
    if (state.aside.is_aside(mate.robot)) state.trust.set_aside(mate.robot, observation.exposure);
  }
  if (is_off_carpet(observation.posture, setting)) {
    state.trust.banish(robot, observation.exposure);
  }
}

/// Takes back what robots said while they stood elsewhere than they said.
void take_back_words(State& state, HostTime exposure, const Parameters& parameters) {
  for (const Teammate& mate : state.teammates) {
    const Quarantine verdict = state.trust.verdict(mate.robot, exposure, parameters.trust);
    if (verdict != Quarantine::kMirrored && verdict != Quarantine::kKidnapped) continue;
    for (BallTrack& ball : state.balls) take_back(ball.book, mate.robot, parameters.ball);
    for (Track& obstacle : state.obstacles) {
      take_back(obstacle.book, mate.robot, parameters.obstacle);
    }
  }
}

CandidateList without(const CandidateList& candidates, const MateSightings& mates) {
  CandidateList others;
  for (std::size_t row = 0; row < candidates.size(); ++row) {
    if (mates.mate_of[row] == kUnassigned) others.push_back(candidates[row]);
  }
  return others;
}

/// Mean variance of a place's two coordinates; m^2.
double variance_of(const Eigen::Matrix2d& cov) {
  return 0.5 * cov.trace();
}

/// Who may kick a ball: teammates that are believed, obstacles, and whom nobody has seen yet.
Kickers kickers_at(const State& state, HostTime exposure, const Setting& setting) {
  static_assert(kMaxFeet >= kMaxRobotId + kMaxTracks);
  const Parameters& parameters = setting.parameters;
  Kickers kickers{{},
                  &state.unseen,
                  Carpet::of(setting.field, parameters.carpet_margin),
                  parameters.newcomer.density,
                  parameters.robot_radius};
  FeetList& feet = kickers.known;
  for (const Teammate& teammate : state.teammates) {
    if (teammate.posture.time == kNever ||
        exposure - teammate.seen > parameters.teammate.forget_age ||
        quarantine_at(state, teammate, exposure, parameters) != Quarantine::kNone) {
      continue;
    }
    const auto carried = carried_to(teammate.posture, exposure, parameters.teammate);
    feet.push_back({carried.X_FR.origin().vector(),
                    variance_of(carried.cov.topLeftCorner<2, 2>()),
                    parameters.robot_radius});
  }
  for (const Track& track : state.obstacles) {
    if (!track.book.is_confirmed) continue;
    const PlanarMoments moments = moments_at(track, exposure, parameters.obstacle);
    feet.push_back(
        {moments.mean.head<2>(), variance_of(moments.cov.topLeftCorner<2, 2>()), track.radius});
  }
  return kickers;
}

/// Says of each obstacle how much is to be doubted if it is no track's, and what the frame tells of
/// those that it does not show.
void weigh_newcomers(UnseenMap& unseen,
                     CandidateList& obstacles,
                     const Scene& scene,
                     const Setting& setting) {
  const Parameters& parameters = setting.parameters;
  const Carpet carpet = Carpet::of(setting.field, parameters.carpet_margin);
  unseen.wander_to(scene.glance.exposure, carpet, parameters.newcomer);
  for (Candidate& candidate : obstacles) {
    const Eigen::Vector2d& p_F = candidate.measurement.p_F;
    const double detected = shown_probability(p_F, scene, parameters.obstacle);
    candidate.doubt = doubt_of_newcomer(unseen.share_at(p_F, carpet), detected, parameters);
  }
  unseen.watch(scene, carpet, parameters.obstacle);
}

void learn_bias(State& state,
                const Observation& observation,
                const Sighted& sighted,
                const Parameters& parameters) {
  const Glance glance{
      observation.id.robot, observation.exposure, observation.sigma_exposure, observation.posture};
  const MateSightings mates = find_teammates(sighted.obstacles, state, observation, parameters);
  learn_from_teammates(state, sighted.obstacles, mates, glance, parameters);
}

/// Takes what the frame shows into teammates' errors and the tracks.
///
/// @return how many balls and obstacles were used
std::size_t take_sighted(State& state,
                         Teammate& observer,
                         const Observation& observation,
                         const Sighted& sighted,
                         const Setting& setting) {
  const Parameters& parameters = setting.parameters;
  const Glance glance{
      observation.id.robot, observation.exposure, observation.sigma_exposure, observation.posture};
  const MateSightings mates = find_teammates(sighted.obstacles, state, observation, parameters);
  learn_from_teammates(state, sighted.obstacles, mates, glance, parameters);
  CandidateList obstacles = without(sighted.obstacles, mates);
  const Sight sight = sight_of(state, observer, glance, parameters);
  const Scene scene{glance, state.errors, sighted.obstacles, sight};
  weigh_newcomers(state.unseen, obstacles, scene, setting);
  BallSetting ball{parameters.ball_motion, parameters.ball};
  ball.motion.high_share = high_share(state.kicks, parameters.ball_motion);
  const Kickers kickers = kickers_at(state, observation.exposure, setting);
  const BallKeys known = confirmed_keys(state.balls);
  const KnownObstacles before = known_obstacles(state.obstacles);
  const std::uint32_t unused =
      take_in(state.balls, {sighted.balls, observation.balls, kickers, state.kicks}, scene, ball) +
      take_in(state.obstacles, obstacles, scene, parameters.obstacle);
  learn_eyesight(state, observer, mates, scene, parameters);
  state.lost_ball = recognise(state.balls, known, state.lost_ball, parameters);
  recognise(state.obstacles, before, state.lost_obstacles, observation.exposure, parameters);
  return sighted.balls.size() + sighted.obstacles.size() - unused;
}

}  // namespace

Quarantine quarantine_at(const State& state,
                         const Teammate& teammate,
                         HostTime now,
                         const Parameters& parameters) {
  const Quarantine own = quarantine_of(teammate, now, parameters.teammate);
  if (own != Quarantine::kNone) return own;
  return state.trust.verdict(teammate.robot, now, parameters.trust);
}

void advance(State& state, const Observation& observation, const Setting& setting) {
  const Parameters& parameters = setting.parameters;
  Teammate& observer = find_or_add(state, observation.id.robot);
  const PostureReport report{observation.posture,
                             state.errors.shake(observation.id.robot, observation.posture),
                             observation.exposure};
  const PostureStep step = take_frame(observer, observation.id, report, parameters);
  note_step(state, observation.id.robot, step, observation.exposure);
  note_errors(state, observation, step, setting);
  if (sees_ball(observation, parameters)) observer.ball_seen = observation.exposure;
  const bool has_posture =
      quarantine_of(observer, observation.exposure, parameters.teammate) == Quarantine::kNone;
  const Sighted sighted = has_posture ? sighted_in(observation, state.errors, setting) : Sighted{};
  if (has_posture) gather_evidence(state, observation, sighted, setting);
  take_back_words(state, observation.exposure, parameters);
  const Quarantine reason = quarantine_at(state, observer, observation.exposure, parameters);
  if (reason != Quarantine::kNone) {
    // How far aside it stands is learned from what it sees of the others, and nothing else.
    if (reason == Quarantine::kBiased) learn_bias(state, observation, sighted, parameters);
    ++observer.rejected_posture;
    return;
  }
  const auto offered = observation.balls.size() + observation.obstacles.size();
  const auto used = take_sighted(state, observer, observation, sighted, setting);
  observer.rejected_gate += static_cast<std::uint32_t>(offered - used);
  observer.accepted += static_cast<std::uint32_t>(used);
}

}  // namespace teamsight::fusion
