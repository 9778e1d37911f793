// vision/localisation/localisation.cpp: one frame into the hypotheses, also a late one.
#include "vision/localisation/localisation.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"
#include "geometry/expect.hpp"
#include "geometry/uncertainty.hpp"
#include "vision/localisation/doubt.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kFewestPoints = 8;
constexpr int kRestart = 10;        // frames running backwards: the camera's clock began again
constexpr double kNewShare = 0.05;  // of one frame in what is smoothed
constexpr double kForget = 0.9;     // of a weight, per frame
constexpr double kGate = 21.1;      // 99.99 % of chi square with 3 degrees of freedom
constexpr double kSlipGate = 16.3;  // 99.9 %
constexpr double kLeanLasts = 1.0;  // s, that a robot accelerates one way
constexpr Duration kSlipLasts = std::chrono::milliseconds(300);
constexpr Duration kSlipBase = std::chrono::milliseconds(200);

bool is_finite(std::span<const LinePoint> points) {
  return std::ranges::all_of(points, [](const LinePoint& point) {
    return point.p_R.vector().allFinite() && point.cov_R.allFinite() && point.cov_R(0, 0) > 0.0 &&
           point.cov_R(1, 1) > 0.0;
  });
}

const PostureFix* fix_of(const RememberedFrame& memory, std::uint32_t hypothesis) {
  for (std::size_t i = 0; i < memory.count; ++i) {
    if (memory.fixes[i].hypothesis == hypothesis) return &memory.fixes[i];
  }
  return nullptr;
}

// As uncertain as the surprise was large.
void widen(Hypothesis& hypothesis, const Eigen::Vector3d& gap) {
  hypothesis.cov.topLeftCorner<3, 3>() += gap * gap.transpose();
  hypothesis.cov.diagonal().head<3>() += 0.25 * gap.cwiseAbs2();
}

}  // namespace

Localiser::Localiser(const FieldModel& field, const LocalisationParameters& parameters)
    : parameters_(parameters),
      map_(field),
      symmetric_(is_half_turn_symmetric(field)) {}

LocalisationState Localiser::begin() const {
  LocalisationState state;
  state.log = MotionLog(parameters_.motion);
  return state;
}

void Localiser::predict(const LocalisationState& state, Belief& belief, HostTime to) const {
  if (to <= belief.at) return;
  const bool slipping = to <= state.slip_until;
  const auto walk = state.log.walk(belief.at, to, slipping);
  const auto newest = state.log.newest(to);
  for (Hypothesis& one : belief.all()) {
    if (walk && newest) {
      carry(one, *walk, *newest);
    } else {
      coast(one, to_seconds(to - belief.at), parameters_.limits);
    }
  }
  belief.at = to;
}

std::optional<double> Localiser::sigma_lean(const LocalisationState& state,
                                            HostTime exposure) const {
  const auto acceleration = state.log.acceleration(exposure);
  if (!acceleration) return std::nullopt;
  return parameters_.sigma_lean + parameters_.lean_per_acceleration * acceleration->norm();
}

HeadTilt Localiser::expected_tilt(const LocalisationState& state, HostTime exposure) const {
  HeadTilt tilt = parameters_.tilt;
  if (state.var_tilt.minCoeff() < 0.0) return tilt;
  tilt.mean = state.tilt;
  if (const auto lean = sigma_lean(state, exposure)) {
    tilt.sigma = (state.var_tilt.array() + *lean * *lean).sqrt();
  }
  return tilt;
}

Located Localiser::see(LocalisationState& state, const FrameEvidence& frame) {
  ++state.counts.frames;
  if (!is_finite(frame.points)) {
    ++state.counts.frames_not_finite;
    return report(state);
  }
  if (state.remembered > 0 && frame.exposure <= state.belief.at) {
    if (take_late(state, frame)) return report(state);
    ++state.counts.frames_backwards;
    if (++state.frames_backwards < kRestart) return report(state);
    restart_clock(state, frame.exposure);
  }
  state.frames_backwards = 0;
  RememberedFrame& memory = state.memory[state.remembered++ % state.memory.size()];
  memory.before = state.belief;
  predict(state, state.belief, frame.exposure);
  take(state, frame, memory);
  state.belief.at = frame.exposure;
  weigh_halves(state, frame);
  return report(state);
}

void Localiser::take(LocalisationState& state,
                     const FrameEvidence& frame,
                     RememberedFrame& memory) {
  memory.exposure = frame.exposure;
  memory.points = frame.points.size();
  memory.count = 0;
  if (frame.points.size() >= kFewestPoints) {
    const HeadTilt tilt = expected_tilt(state, frame.exposure);
    for (const Hypothesis& one : state.belief.all()) {
      memory.fixes[memory.count++] = {
          one.id, fitter_.fit(map_, frame.points, one, tilt, state.correlation)};
    }
  }
  correct_all(state, state.belief, memory);
}

void Localiser::notice_slip(LocalisationState& state,
                            const PostureFix& fix,
                            HostTime exposure) const {
  if (!state.last_posture || state.last_posture->hypothesis != fix.hypothesis) return;
  if (exposure - state.last_fix > kSlipBase || !fix.fit.observable) return;
  const auto walk = state.log.walk(state.last_fix, exposure, false);
  if (!walk) return;
  const PostureFit& last = state.last_posture->fit;
  Hypothesis expected;
  expected.X_FR = last.X_FR;
  expected.cov.topLeftCorner<3, 3>() = last.cov;
  carry(expected, *walk, {});
  if (innovation_of(expected, fix.fit.X_FR, fix.fit.cov).nis <= kSlipGate) return;
  if (exposure > state.slip_until) ++state.counts.slips;
  state.slip_until = exposure + kSlipLasts;
}

void Localiser::weigh(Belief& belief, const RememberedFrame& memory) const {
  double most = 1e-9;
  for (std::size_t i = 0; i < memory.count; ++i) {
    most = std::max(most, memory.fixes[i].fit.support);
  }
  // With hardly any line in sight all places fit: differences of a few votes say little.
  most = std::max(most, 0.3 * static_cast<double>(memory.points));
  for (Hypothesis& one : belief.all()) {
    const PostureFix* fix = fix_of(memory, one.id);
    if (fix == nullptr) continue;
    one.log_weight = kForget * one.log_weight + kVoteEvidence * (fix->fit.support - most) / most;
  }
  belief.tidy(symmetric_, map_.field().centre);
}

bool Localiser::supports(const LocalisationState& state,
                         const PostureFit& fit,
                         std::size_t points) const {
  const double share = fit.support / static_cast<double>(points);
  const double usual = state.usual_support < 0.0 ? kLostSupport : state.usual_support;
  return share >= std::max(kLeastSupport, kKeptSupport * usual) &&
         fit.inlier_ratio >= kLeastSupport;
}

void Localiser::watch_slip(LocalisationState& state,
                           Belief& belief,
                           const RememberedFrame& memory) const {
  const PostureFix* fix = fix_of(memory, belief.places[0].id);
  if (fix == nullptr || !supports(state, fix->fit, memory.points)) return;
  const bool was_slipping = memory.exposure <= state.slip_until;
  notice_slip(state, *fix, memory.exposure);
  if (was_slipping || memory.exposure > state.slip_until) return;
  keep_half(state, belief.places[0], fix->fit, memory.exposure);
  for (Hypothesis& one : belief.all()) {
    widen(one, innovation_of(one, fix->fit.X_FR, fix->fit.cov).gap);
  }
}

std::optional<Eigen::Vector3d> Localiser::take_fix(const LocalisationState& state,
                                                   Hypothesis& one,
                                                   const PostureFit& fit,
                                                   HostTime exposure) const {
  const Innovation innovation = innovation_of(one, fit.X_FR, fit.cov);
  const bool is_surprise = innovation.nis > kGate;
  if (is_surprise) {
    keep_half(state, one, fit, exposure);
    widen(one, innovation.gap);
  }
  correct(one, fit.X_FR, independent_part(fit, state.correlation));
  if (!is_surprise) return std::nullopt;
  return turned(one.X_FR.rotation()).transpose() * innovation.gap;
}

void Localiser::correct_best(LocalisationState& state,
                             Hypothesis& best,
                             const RememberedFrame& memory) const {
  const PostureFix* fix = fix_of(memory, best.id);
  if (fix == nullptr || !supports(state, fix->fit, memory.points)) {
    ++state.counts.misses;
    doubt(state, memory.exposure);
    return;
  }
  if (const auto gap = take_fix(state, best, fix->fit, memory.exposure)) {
    ++state.counts.surprises;
    doubt(state, memory.exposure);
    state.is_rivalled = true;
    state.rival_gap = *gap;
  }
  learn(state, fix->fit, memory);
}

void Localiser::correct_all(LocalisationState& state,
                            Belief& belief,
                            const RememberedFrame& memory) const {
  if (memory.count == 0 || belief.count == 0) return;
  const std::uint32_t best_before = belief.places[0].id;
  watch_slip(state, belief, memory);
  weigh(belief, memory);
  correct_best(state, belief.places[0], memory);
  for (Hypothesis& one : belief.all().subspan(1)) {
    const PostureFix* fix = fix_of(memory, one.id);
    if (fix == nullptr || !supports(state, fix->fit, memory.points)) continue;
    take_fix(state, one, fix->fit, memory.exposure);
  }
  if (belief.places[0].id != best_before) ++state.counts.jumps;
  const PostureFix* fix = fix_of(memory, belief.places[0].id);
  if (fix != nullptr) state.last_posture = *fix;
}

void Localiser::learn(LocalisationState& state,
                      const PostureFit& fit,
                      const RememberedFrame& memory) const {
  const HostTime exposure = memory.exposure;
  const double passed = state.last_fix == HostTime{}
                            ? 0.0
                            : std::clamp(to_seconds(exposure - state.last_fix), 0.0, 10.0);
  state.last_fix = std::max(state.last_fix, exposure);
  const double share = fit.support / static_cast<double>(memory.points);
  if (state.usual_support < 0.0) state.usual_support = share;
  if (share < kDoubtedSupport * state.usual_support) {
    doubt(state, exposure);
  } else {
    state.usual_support += kNewShare * (share - state.usual_support);
  }
  if (!fit.observable) return;
  state.correlation += kNewShare * (std::min(fit.correlation, 20.0) - state.correlation);
  const HeadTilt expected = expected_tilt(state, exposure);
  if (state.var_tilt.minCoeff() < 0.0) state.var_tilt = parameters_.tilt.sigma.cwiseAbs2();
  const auto told = sigma_lean(state, exposure);
  for (int axis = 0; axis < 2; ++axis) {
    const double prior = expected.sigma(axis) * expected.sigma(axis);
    const double gain = 1.0 - fit.var_tilt(axis) / prior;
    if (prior <= 1e-12 || gain < 0.02) continue;
    // What the frame alone says of the tilt, and how it moves the tilt at rest.
    const double measured = expected.mean(axis) + (fit.tilt(axis) - expected.mean(axis)) / gain;
    const double rest = state.var_tilt(axis) + std::pow(parameters_.sigma_tilt_drift, 2) * passed;
    // One lean lasts for many frames: it counts once for all of them.
    const double lean = std::pow(told.value_or(parameters_.tilt.sigma(axis)), 2) *
                        std::max(1.0, kLeanLasts / std::max(passed, 0.01));
    const double weight = rest / (rest + lean + fit.var_tilt(axis) / gain);
    state.tilt(axis) += weight * (measured - state.tilt(axis));
    state.var_tilt(axis) = (1.0 - weight) * rest;
  }
}

bool Localiser::take_late(LocalisationState& state, const FrameEvidence& frame) {
  const std::size_t kept = std::min(state.remembered, state.memory.size());
  // The frames that are newer than this one, the newest first.
  std::size_t newer = 0;
  while (newer < kept) {
    const auto& memory = state.memory[(state.remembered - 1 - newer) % state.memory.size()];
    if (memory.exposure < frame.exposure) break;
    if (memory.exposure == frame.exposure) return false;
    ++newer;
  }
  if (newer == kept) return false;
  ++state.counts.frames_late;
  std::array<RememberedFrame, std::tuple_size_v<decltype(state.memory)>> later;
  for (std::size_t i = 0; i < newer; ++i) {
    later[i] = state.memory[(state.remembered - newer + i) % state.memory.size()];
  }
  state.belief = later[0].before;
  state.remembered -= newer;
  RememberedFrame& memory = state.memory[state.remembered++ % state.memory.size()];
  memory.before = state.belief;
  predict(state, state.belief, frame.exposure);
  take(state, frame, memory);
  for (std::size_t i = 0; i < newer; ++i) {
    later[i].before = state.belief;
    predict(state, state.belief, later[i].exposure);
    state.memory[state.remembered++ % state.memory.size()] = later[i];
    correct_all(state, state.belief, later[i]);
  }
  return true;
}

void Localiser::restart_clock(LocalisationState& state, HostTime exposure) const {
  state.belief.at = exposure;
  state.remembered = 0;
  state.last_fix = {};
  state.last_search = {};
  state.slip_until = {};
  state.doubt_since = exposure;
  state.last_posture.reset();
  const Eigen::Vector3d anywhere_near(0.5, 0.5, 0.3);
  for (Hypothesis& one : state.belief.all()) {
    one.cov.diagonal().head<3>() += anywhere_near.cwiseAbs2();
  }
}

}  // namespace teamsight::vision
