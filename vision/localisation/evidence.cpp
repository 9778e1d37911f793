// vision/localisation/evidence.cpp: searches, halves, what is said of it all.
#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"
#include "geometry/uncertainty.hpp"
#include "vision/localisation/doubt.hpp"
#include "vision/localisation/localisation.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kFewestForSearch = 15;
constexpr Duration kSearchWhenLost = std::chrono::milliseconds(30);
constexpr Duration kSearchInDoubt = std::chrono::milliseconds(80);
constexpr Duration kSearchAnyway = std::chrono::milliseconds(700);
constexpr Duration kOldAnswer = std::chrono::milliseconds(600);
constexpr Duration kCompassTime = std::chrono::seconds(1);  // over which its errors are alike
constexpr double kSamePlace = 0.3;      // m, of a search's answer and a hypothesis
constexpr double kSameHeading = 0.2;    // rad
constexpr double kMostUnlikely = -3.0;  // of a jump, in log
constexpr double kGoalShare = 0.1;      // of a frame's goals: frames are alike
constexpr double kMostTeamOdds = 10.0;
constexpr int kFramesToFlip = 5;
constexpr double kLongBlind = 3.0;  // s without a fix, after which nothing is ok

bool is_near(const Pose<Field, Robot>& a, const Pose<Field, Robot>& b) {
  return (a.origin().vector() - b.origin().vector()).norm() < kSamePlace &&
         std::abs(angle_difference(a.theta(), b.theta())) < kSameHeading;
}

double log_density(const Pose<Field, Robot>& X_FR, const MotionPrior& prior) {
  Eigen::Vector3d gap = X_FR.vector() - prior.X_FR->vector();
  gap.z() = wrap_angle(gap.z());
  return -0.5 * squared_mahalanobis(gap, prior.cov);
}

void turn_round(Hypothesis& hypothesis, const Point<Field>& centre) {
  hypothesis = mirrored(hypothesis, centre);
}

double clamp_half(double odds) {
  return std::clamp(odds, -kMaxHalfLogOdds, kMaxHalfLogOdds);
}

}  // namespace

BackgroundSearch::BackgroundSearch(const FieldModel& field)
    : map_(field),
      search_(map_, is_half_turn_symmetric(field)) {}

SearchAnswer BackgroundSearch::answer(const SearchRequest& request) {
  SearchAnswer answer;
  answer.exposure = request.exposure;
  answer.tracked = request.tracked;
  if (request.points.empty()) return answer;
  const auto count = static_cast<double>(request.points.size());
  for (const PostureFit& fit : search_.search(map_, request.points, fitter_, request.tilt)) {
    const double support = fit.support / count;
    // Scattered points give few votes though they lie on the lines, by their own sigma.
    const bool is_good = fit.observable && std::min(support, fit.inlier_ratio) >= kSomeSupport &&
                         support + fit.inlier_ratio >= 2.0 * kLostSupport;
    if (is_good) answer.places.push_back(fit);
  }
  return answer;
}

std::optional<SearchRequest> Localiser::wanted_search(LocalisationState& state,
                                                      const FrameEvidence& frame) const {
  if (state.is_searching || frame.points.size() < kFewestForSearch) return std::nullopt;
  if (frame.exposure != state.belief.at) return std::nullopt;
  const bool in_doubt = state.doubt_since != HostTime{} || state.is_rivalled;
  const Duration pause = state.belief.count == 0 ? kSearchWhenLost
                         : in_doubt              ? kSearchInDoubt
                                                 : kSearchAnyway;
  if (state.last_search != HostTime{} && frame.exposure - state.last_search < pause) {
    return std::nullopt;
  }
  state.is_searching = true;
  state.last_search = frame.exposure;
  SearchRequest request;
  request.exposure = frame.exposure;
  request.points.assign(frame.points.begin(), frame.points.end());
  request.tilt = expected_tilt(state, frame.exposure);
  const bool is_known = state.belief.count > 0 && state.last_posture &&
                        state.last_posture->hypothesis == state.belief.places[0].id;
  if (is_known) request.tracked = state.last_posture->fit;
  return request;
}

Hypothesis Localiser::standing_at(LocalisationState& state,
                                  const Pose<Field, Robot>& X_FR,
                                  const Eigen::Matrix3d& cov) const {
  Hypothesis hypothesis;
  hypothesis.id = state.next_id++;
  hypothesis.X_FR = X_FR;
  const double sigma_v = parameters_.limits.sigma_velocity;
  const double sigma_omega = parameters_.limits.sigma_omega;
  hypothesis.cov.topLeftCorner<3, 3>() = cov;
  hypothesis.cov.diagonal().tail<3>() << sigma_v * sigma_v, sigma_v * sigma_v,
      sigma_omega * sigma_omega;
  return hypothesis;
}

double Localiser::reach_of_a_push(const LocalisationState& state, HostTime now) const {
  return kNearReach + kFastest * std::clamp(to_seconds(now - state.last_fix), 0.0, 10.0);
}

void Localiser::keep_half(const LocalisationState& state,
                          Hypothesis& one,
                          const PostureFit& fit,
                          HostTime exposure) const {
  // Of a place that was named and never seen, a surprise says how well it was named.
  if (!symmetric_ || state.last_fix == HostTime{}) return;
  const MotionPrior expected{
      .X_FR = one.X_FR, .cov = one.cov_pose() + fit.cov, .half_log_odds = one.half_log_odds};
  one.half_log_odds =
      half_log_odds_after_jump(fit.X_FR, expected, reach_of_a_push(state, exposure), map_.field());
}

void Localiser::join(const LocalisationState& state,
                     Hypothesis& found,
                     const Belief& before) const {
  const Point<Field>& centre = map_.field().centre;
  const Hypothesis& best = before.places[0];
  const double reach = reach_of_a_push(state, before.at);
  MotionPrior expected{.X_FR = best.X_FR, .half_log_odds = best.half_log_odds};
  expected.cov = best.cov_pose() + found.cov_pose();
  found.half_log_odds = symmetric_
                            ? half_log_odds_after_jump(found.X_FR, expected, reach, map_.field())
                            : kMaxHalfLogOdds;
  expected.cov += reach * reach * Eigen::Matrix3d::Identity();
  double continuity = log_density(found.X_FR, expected);
  if (symmetric_) {
    continuity = std::max(continuity, log_density(mirrored(found.X_FR, centre), expected));
  }
  found.log_weight = best.log_weight + std::max(continuity, kMostUnlikely);
}

Hypothesis Localiser::from_search(LocalisationState& state,
                                  const PostureFit& place,
                                  HostTime exposure,
                                  const Belief& before) const {
  Belief one;
  one.at = exposure;
  one.add(standing_at(state, place.X_FR, place.cov));
  predict(state, one, before.at);
  Hypothesis& found = one.places[0];
  const Point<Field>& centre = map_.field().centre;
  if (before.count > 0) {
    join(state, found, before);
  } else if (symmetric_) {
    const StartSide side = state.has_started ? StartSide::kUnknown : parameters_.start_side;
    found.half_log_odds =
        half_log_odds_from_side(place.X_FR, std::sqrt(place.cov(0, 0)), side, centre);
  } else {
    found.half_log_odds = kMaxHalfLogOdds;
  }
  if (found.half_log_odds < 0.0) turn_round(found, centre);
  return found;
}

bool Localiser::take_place(LocalisationState& state,
                           const PostureFit& place,
                           const SearchAnswer& answer,
                           const Belief& before) const {
  const Point<Field>& centre = map_.field().centre;
  Hypothesis found = from_search(state, place, answer.exposure, before);
  const auto known = std::ranges::find_if(state.belief.all(), [&](const Hypothesis& other) {
    return is_near(found.X_FR, other.X_FR) ||
           (symmetric_ && is_near(mirrored(found.X_FR, centre), other.X_FR));
  });
  if (known != state.belief.all().end()) return known == state.belief.all().begin();
  const double tracked = answer.tracked ? answer.tracked->support : answer.places.front().support;
  found.log_weight +=
      kVoteEvidence * (place.support - tracked) / std::max({place.support, tracked, 1.0});
  state.belief.add(found);
  return false;
}

void Localiser::insert(LocalisationState& state, const SearchAnswer& answer) const {
  state.is_searching = false;
  if (state.belief.at - answer.exposure > kOldAnswer || answer.exposure > state.belief.at) return;
  if (answer.places.empty()) return;
  const Belief before = state.belief;
  const bool is_confirmed = take_place(state, answer.places.front(), answer, before);
  for (const PostureFit& place : std::span(answer.places).subspan(1)) {
    take_place(state, place, answer, before);
  }
  const bool is_first = before.count == 0;
  state.belief.tidy(symmetric_, map_.field().centre);
  const bool has_jumped = !is_first && state.belief.places[0].id != before.places[0].id;
  if (has_jumped) ++state.counts.jumps;
  if (is_confirmed || has_jumped || is_first) {
    state.doubt_since = {};
    state.is_rivalled = false;
    state.usual_support = -1.0;
  }
  if (has_jumped || is_first) {
    state.last_fix = state.belief.at;
    state.team_log_odds = 0.0;
    state.last_posture.reset();
  }
}

void Localiser::doubt(LocalisationState& state, HostTime when) const {
  if (state.doubt_since == HostTime{}) state.doubt_since = when;
}

void Localiser::weigh_halves(LocalisationState& state, const FrameEvidence& frame) const {
  if (state.belief.count == 0) return;
  const Point<Field>& centre = map_.field().centre;
  for (Hypothesis& one : state.belief.all()) {
    if (!symmetric_) {
      one.half_log_odds = kMaxHalfLogOdds;
      continue;
    }
    const double odds = half_log_odds_from_goals(one.X_FR, map_.field(), frame.goals);
    one.half_log_odds = clamp_half(one.half_log_odds + kGoalShare * odds);
  }
  Hypothesis& best = state.belief.places[0];
  const double total = best.half_log_odds + state.team_log_odds;
  state.frames_to_flip = total < -kSureHalf ? state.frames_to_flip + 1 : 0;
  if (state.frames_to_flip >= kFramesToFlip) {
    ++state.counts.flips;
    turn_round(best, centre);
    state.team_log_odds = -state.team_log_odds;
    state.frames_to_flip = 0;
    if (state.last_posture) {
      state.last_posture->fit.X_FR = mirrored(state.last_posture->fit.X_FR, centre);
    }
  }
  if (status_of(state) == PostureStatus::kOk) state.has_started = true;
}

void Localiser::roll(LocalisationState& state, const WheelReading& reading) const {
  const InputReject reject = state.log.roll(reading);
  if (reject == InputReject::kNotFinite) ++state.counts.inputs_not_finite;
  if (reject == InputReject::kBackwards) ++state.counts.inputs_backwards;
}

void Localiser::turn(LocalisationState& state, const GyroReading& reading) const {
  const InputReject reject = state.log.turn(reading);
  if (reject == InputReject::kNotFinite) ++state.counts.inputs_not_finite;
  if (reject == InputReject::kBackwards) ++state.counts.inputs_backwards;
}

void Localiser::point(LocalisationState& state, const CompassReading& reading) const {
  if (!std::isfinite(reading.heading) || !(reading.sigma > 0.0)) {
    ++state.counts.inputs_not_finite;
    return;
  }
  if (state.last_compass != HostTime{} && reading.stamp <= state.last_compass) {
    ++state.counts.inputs_backwards;
    // A compass whose clock began again is heard from the next reading on.
    if (state.last_compass - reading.stamp > kCompassTime) state.last_compass = reading.stamp;
    return;
  }
  const double passed =
      state.last_compass == HostTime{}
          ? 1.0
          : to_seconds(reading.stamp - state.last_compass) / to_seconds(kCompassTime);
  state.last_compass = reading.stamp;
  if (!symmetric_) return;
  for (Hypothesis& one : state.belief.all()) {
    const double odds = half_log_odds_from_compass(one.X_FR, reading);
    one.half_log_odds = clamp_half(one.half_log_odds + std::min(passed, 1.0) * odds);
  }
}

void Localiser::hear_team(LocalisationState& state, double log_odds) const {
  if (!std::isfinite(log_odds)) {
    ++state.counts.inputs_not_finite;
    return;
  }
  state.team_log_odds = std::clamp(log_odds, -kMostTeamOdds, kMostTeamOdds);
}

void Localiser::place(LocalisationState& state,
                      const Pose<Field, Robot>& X_FR,
                      const Eigen::Matrix3d& cov,
                      HostTime when) const {
  if (!X_FR.vector().allFinite() || !is_covariance(cov)) {
    ++state.counts.inputs_not_finite;
    return;
  }
  Hypothesis hypothesis = standing_at(state, X_FR, cov);
  // Whoever says where the robot stands also says on which half.
  hypothesis.half_log_odds = kMaxHalfLogOdds;
  state.belief.count = 0;
  state.belief.add(hypothesis);
  state.belief.at = when;
  state.remembered = 0;
  state.team_log_odds = 0.0;
  state.has_started = true;
  // A place that was only named must be seen to be good before it is believed.
  state.usual_support = kNamedSupport;
  state.last_fix = {};
  state.last_search = {};
  state.last_posture.reset();
  state.doubt_since = {};
  state.is_rivalled = false;
}

std::optional<Hypothesis> Localiser::at(const LocalisationState& state, HostTime when) const {
  if (state.belief.count == 0) return std::nullopt;
  Belief best;
  best.at = state.belief.at;
  best.add(state.belief.places[0]);
  predict(state, best, when);
  return best.places[0];
}

PostureStatus Localiser::status_of(const LocalisationState& state) const {
  if (state.belief.count == 0) return PostureStatus::kLost;
  const Hypothesis& best = state.belief.places[0];
  const double sigma = best.sigma_position();
  if (sigma > kLostSigma || state.last_fix == HostTime{}) return PostureStatus::kLost;
  const bool is_doubted =
      state.doubt_since != HostTime{} && state.belief.at - state.doubt_since >= kDoubtTold;
  const bool is_blind = to_seconds(state.belief.at - state.last_fix) > kLongBlind;
  const bool is_sure = !is_doubted && !is_blind && !state.is_rivalled && sigma < kOkSigma &&
                       state.belief.share_of_best() >= kSureShare &&
                       best.half_log_odds + state.team_log_odds >= kSureHalf;
  return is_sure ? PostureStatus::kOk : PostureStatus::kAmbiguous;
}

Located Localiser::report(const LocalisationState& state) const {
  Located located;
  PostureEstimate& posture = located.posture;
  located.is_slipping = state.belief.at <= state.slip_until && state.belief.at != HostTime{};
  if (state.remembered > 0) {
    const auto& memory = state.memory[(state.remembered - 1) % state.memory.size()];
    posture.line_points = static_cast<std::uint16_t>(std::min<std::size_t>(memory.points, 65535));
  }
  posture.status = status_of(state);
  located.half_log_odds_team = state.team_log_odds;
  if (state.belief.count == 0) return located;
  const Hypothesis& best = state.belief.places[0];
  posture.X_FR = best.X_FR;
  posture.half_log_odds = best.half_log_odds;
  posture.cov = best.cov_pose();
  PostureFit seen;
  if (state.last_posture && state.last_posture->hypothesis == best.id) {
    seen = state.last_posture->fit;
    posture.inlier_ratio = seen.inlier_ratio;
    located.tilt = seen.tilt;
    located.scale = seen.scale;
    if (seen.observable) posture.cov += seen.cov - independent_part(seen, state.correlation);
  }
  posture.cov += shared_part(seen, parameters_.shared);
  if (state.is_rivalled) {
    // It may also be where it was expected.
    const Eigen::Vector3d gap = turned(best.X_FR.rotation()) * state.rival_gap;
    posture.cov += gap * gap.transpose();
  }
  return located;
}

}  // namespace teamsight::vision
