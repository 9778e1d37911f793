// fusion/ball_beliefs.cpp: see fusion/ball_beliefs.hpp.
#include "fusion/ball_beliefs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

namespace teamsight::fusion {
namespace {

// What is less probable than this has not happened.
constexpr double kLeastProbability = 1e-5;
// Only what is as probable as this is asked what a kick would make of it.
constexpr double kWorthSplitting = 0.03;

/// Places in the list for each way of moving: the many instants of a kick along the floor must not
/// crowd out the rarer one into the air. Index: BallMode.
constexpr std::array<std::size_t, kBallModes> kPlaces{10, 6, 2};
static_assert(kPlaces[0] + kPlaces[1] + kPlaces[2] == kMaxBallBeliefs);

/// Of the possibilities that move like this, the least probable; the list's size if there is none.
std::size_t least_probable(const BallBeliefs& beliefs, BallMode mode) {
  std::size_t least = beliefs.size();
  for (std::size_t i = 0; i < beliefs.size(); ++i) {
    if (beliefs[i].mode != mode) continue;
    if (least == beliefs.size() || beliefs[i].probability < beliefs[least].probability) least = i;
  }
  return least;
}

/// The same; the list's size if there still is room for one more.
std::size_t superfluous(const BallBeliefs& beliefs, BallMode mode) {
  const auto alike = static_cast<std::size_t>(
      std::count_if(beliefs.begin(), beliefs.end(), [&](const BallBelief& belief) {
        return belief.mode == mode;
      }));
  const bool is_room = alike < kPlaces[static_cast<std::size_t>(mode)] && !beliefs.is_full();
  return is_room ? beliefs.size() : least_probable(beliefs, mode);
}

/// Both as one, with their common mean and covariance.
BallBelief merged(const BallBelief& a, const BallBelief& b) {
  BallBelief both = a.seen < b.seen ? b : a;
  both.state = a.state;
  both.probability = a.probability + b.probability;
  const double share = b.probability / both.probability;
  const BallVector gap = b.state.mean - a.state.mean;
  both.state.mean += share * gap;
  both.state.cov = (1.0 - share) * a.state.cov + share * b.state.cov +
                   share * (1.0 - share) * gap * gap.transpose();
  both.state.cross = (1.0 - share) * a.state.cross + share * b.state.cross;
  return both;
}

/// Puts one more in. Where there is no room, the two least probable of its kind become one: many of
/// which none matters are not forgotten together.
void put(BallBeliefs& beliefs, const BallBelief& belief) {
  if (const std::size_t least = superfluous(beliefs, belief.mode); least < beliefs.size()) {
    const BallBelief rest = beliefs[least];
    beliefs.erase(least);
    const std::size_t next = least_probable(beliefs, belief.mode);
    if (next < beliefs.size()) beliefs[next] = merged(beliefs[next], rest);
  }
  if (!beliefs.is_full()) beliefs.push_back(belief);
}

void normalise(BallBeliefs& beliefs) {
  double sum = 0.0;
  for (const BallBelief& belief : beliefs) sum += belief.probability;
  for (BallBelief& belief : beliefs) belief.probability /= sum;
}

void take_step(BallBelief& belief, const BallStep& step, const BallMotion& motion) {
  belief.state.predict(step.transition, step.mean, step.disturbance);
  if (!step.lands) return;
  belief.mode = BallMode::kRolling;
  lay_down(belief.state, motion);
}

BallStep step_of(const BallBelief& belief, double dt, const BallMotion& motion) {
  switch (belief.mode) {
    case BallMode::kRolling:
      return step_rolling(belief.state.mean, dt, motion.rolling_psd, motion);
    case BallMode::kLed:
      return step_led(belief.state.mean, dt, motion);
    case BallMode::kFlying:
      break;
  }
  return step_flying(belief.state.mean, dt, motion);
}

/// Kicks are soft, hard or into the air; shares add up to 1.
struct KickKind {
  BallMode into{BallMode::kRolling};
  double sigma{0.0};  // see Kick
  double share{0.0};
};

std::array<KickKind, 3> kinds_of_kick(const BallMotion& motion) {
  const double along = 1.0 - motion.high_share;
  return {{{BallMode::kRolling, motion.sigma_shot, along * motion.shot_share},
           {BallMode::kRolling, motion.sigma_pass, along * (1.0 - motion.shot_share)},
           {BallMode::kFlying, motion.sigma_high, motion.high_share}}};
}

/// How often, and into which direction, a ball would be kicked that is where a possibility says.
struct KickChance {
  double rate{0.0};  // 1/s
  Eigen::Vector2d away{Eigen::Vector2d::Zero()};
  double touched{0.0};  // that a robot touches it, in [0, 1]
};

KickChance chance_of(const BallBelief& belief, const Kickers& kickers, const BallMotion& motion) {
  if (belief.state.mean(2) > motion.foot_height) return {};
  const BallPlace place{belief.state.mean.head<2>(),
                        0.5 * (belief.state.cov(0, 0) + belief.state.cov(1, 1))};
  const Touch touch = likeliest_touch(place, kickers.known, motion.foot_reach);
  // One that runs into a robot comes back at once.
  const double towards = std::max(0.0, -touch.away.dot(belief.state.mean.segment<2>(3)));
  const double by_known =
      touch.probability * (motion.kicks_at_foot + towards / motion.stopping_way);
  const double unseen = (1.0 - touch.probability) *
                        (kickers.is_silence ? motion.kicks_in_play / motion.kicks_at_foot
                                            : unseen_touch(place, kickers, motion.foot_reach));
  const double rate = by_known + unseen * motion.kicks_at_foot + motion.kicks_alone;
  const double touched = touch.probability + unseen;
  if (rate <= 0.0) return {0.0, Eigen::Vector2d::Zero(), touched};
  return {rate, (by_known / rate) * touch.away, touched};
}

BallBelief kicked(const BallBelief& before, double dt, const Kick& kick, const BallMotion& motion) {
  BallBelief belief = before;
  const BallStep step = step_kicked(before.state.mean, dt, kick, motion);
  belief.mode = belief.kicked_into = kick.into;
  belief.since_kick = 0.5 * dt;
  belief.state.predict(step.transition, step.mean, step.disturbance);
  if (kick.into == BallMode::kRolling) lay_down(belief.state, motion);
  return belief;
}

/// The same ball, which something leads from now on, or no longer.
///
/// @param touched  that a robot touches it, in [0, 1]
BallBelief changed_hands(BallBelief& before, double dt, double touched, const BallMotion& motion) {
  const bool is_led = before.mode == BallMode::kLed;
  const double rate =
      is_led ? motion.leads_end : motion.leads_alone + touched * motion.leads_at_foot;
  const double change = 1.0 - std::exp(-rate * dt);
  BallBelief after = before;
  // At an unknown instant: on average it has been led for half of the time.
  if (!is_led) after.state.cov += led_for_a_part(dt, motion);
  after.mode = is_led ? BallMode::kRolling : BallMode::kLed;
  after.probability *= change;
  before.probability *= 1.0 - change;
  return after;
}

/// What two beliefs are compared by.
struct Shape {
  Eigen::LLT<BallMatrix> factor;
  double log_determinant{0.0};

  Shape() = default;

  explicit Shape(const BallBelief& belief) : factor(belief.state.cov) {
    log_determinant = 2.0 * BallMatrix(factor.matrixL()).diagonal().array().log().sum();
  }
};

bool is_alike(const BallBelief& a, const Shape& in_a, const BallBelief& b, const Shape& in_b) {
  constexpr double kMostLogRatio = 1.5;  // of the volumes of their covariances
  constexpr double kMostDistance = 0.5;  // squared, in standard deviations of either
  if (a.mode != b.mode) return false;
  if (std::abs(in_a.log_determinant - in_b.log_determinant) > kMostLogRatio) return false;
  const BallVector gap = b.state.mean - a.state.mean;
  return gap.dot(in_a.factor.solve(gap)) < kMostDistance &&
         gap.dot(in_b.factor.solve(gap)) < kMostDistance;
}

/// Adds one; if there is no room for more of its kind, the least probable of them is forgotten.
void add_probable(BallBeliefs& beliefs, const BallBelief& belief) {
  const std::size_t least = superfluous(beliefs, belief.mode);
  if (least == beliefs.size()) return beliefs.push_back(belief);
  if (beliefs[least].probability < belief.probability) beliefs[least] = belief;
}

void merge_alike(BallBeliefs& beliefs) {
  InlineList<Shape, kMaxBallBeliefs> shapes;
  for (const BallBelief& belief : beliefs) shapes.push_back(Shape(belief));
  for (std::size_t i = 0; i < beliefs.size(); ++i) {
    for (std::size_t j = beliefs.size(); j-- > i + 1;) {
      if (!is_alike(beliefs[i], shapes[i], beliefs[j], shapes[j])) continue;
      beliefs[i] = merged(beliefs[i], beliefs[j]);
      beliefs.erase(j);
      shapes.erase(j);
    }
  }
}

}  // namespace

void lay_down(Considered<6>& state, const BallMotion& motion) {
  const double var = motion.sigma_floor * motion.sigma_floor;
  for (const int fixed : {2, 5}) {
    state.cov.row(fixed).setZero();
    state.cov.col(fixed).setZero();
    state.cov(fixed, fixed) = var;
    state.cross.row(fixed).setZero();
  }
  state.mean(2) = motion.radius;
  state.mean(5) = 0.0;
}

void advance(BallBeliefs& beliefs, double dt, const BallMotion& motion) {
  for (BallBelief& belief : beliefs) {
    belief.since_kick += dt;
    take_step(belief, step_of(belief, dt, motion), motion);
    if (const auto rebound = step_rebound(belief.state.mean, motion)) {
      take_step(belief, *rebound, motion);
    }
  }
}

double kick_rate(const BallBeliefs& beliefs, const Kickers& kickers, const BallMotion& motion) {
  double rate = 0.0;
  for (const BallBelief& belief : beliefs) {
    rate += belief.probability * chance_of(belief, kickers, motion).rate;
  }
  return rate;
}

void split_off_kicks(BallBeliefs& beliefs,
                     double dt,
                     const Kickers& kickers,
                     const BallMotion& motion) {
  BallBeliefs kicks;
  BallBeliefs others;
  for (BallBelief& belief : beliefs) {
    if (belief.probability < kWorthSplitting) continue;
    const KickChance chance = chance_of(belief, kickers, motion);
    if (belief.mode != BallMode::kFlying) {
      others.push_back(changed_hands(belief, dt, chance.touched, motion));
    }
    const double kick = 1.0 - std::exp(-chance.rate * dt);
    if (kick <= 0.0) continue;
    for (const KickKind& kind : kinds_of_kick(motion)) {
      BallBelief after = kicked(belief, dt, {kind.into, chance.away, kind.sigma}, motion);
      after.probability *= kick * kind.share;
      put(kicks, after);
    }
    belief.probability *= 1.0 - kick;
  }
  for (const BallBelief& kick : kicks) put(beliefs, kick);
  for (const BallBelief& other : others) put(beliefs, other);
  normalise(beliefs);
}

void add_others(BallBeliefs& beliefs, const BallBeliefs& others) {
  double sum = 0.0;
  for (const BallBelief& belief : beliefs) sum += belief.probability;
  for (const BallBelief& belief : others) sum += belief.probability;
  std::array<BallBelief, kBallModes> rest;
  for (const BallBelief& other : others) {
    BallBelief& alike = rest[static_cast<std::size_t>(other.mode)];
    if (other.probability >= kWorthSplitting * sum) {
      add_probable(beliefs, other);
    } else if (other.probability > 0.0) {
      alike = alike.probability > 0.0 ? merged(alike, other) : other;
    }
  }
  for (const BallBelief& belief : rest) {
    if (belief.probability > kLeastProbability * sum) add_probable(beliefs, belief);
  }
}

void tidy(BallBeliefs& beliefs) {
  normalise(beliefs);
  for (std::size_t i = beliefs.size(); i-- > 0;) {
    if (beliefs[i].probability < kLeastProbability) beliefs.erase(i);
  }
  normalise(beliefs);
  merge_alike(beliefs);
}

BallMoments moments_of(const BallBeliefs& beliefs) {
  BallMoments moments;
  moments.mean.setZero();
  moments.cov.setZero();
  for (const BallBelief& belief : beliefs) {
    moments.mean += belief.probability * belief.state.mean;
  }
  for (const BallBelief& belief : beliefs) {
    const BallVector gap = belief.state.mean - moments.mean;
    moments.cov += belief.probability * (belief.state.cov + gap * gap.transpose());
  }
  return moments;
}

void doubt_kicks(BallMoments& moments, double dt, double rate, const BallMotion& motion) {
  const double chance = 1.0 - std::exp(-rate * dt);
  double along = 0.0;
  for (const KickKind& kind : kinds_of_kick(motion)) along += kind.share * kind.sigma * kind.sigma;
  const double up = motion.climb * motion.climb + motion.sigma_climb * motion.sigma_climb;
  Eigen::Vector3d changed = Eigen::Vector3d(along, along, motion.high_share * up);
  changed.head<2>() += moments.mean.segment<2>(3).cwiseAbs2();
  changed *= chance;
  moments.cov.diagonal().head<3>() += dt * dt / 3.0 * changed;
  moments.cov.diagonal().tail<3>() += changed;
  moments.cov.topRightCorner<3, 3>().diagonal() += dt / 2.0 * changed;
  moments.cov.bottomLeftCorner<3, 3>().diagonal() += dt / 2.0 * changed;
}

}  // namespace teamsight::fusion
