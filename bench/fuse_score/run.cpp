// bench/fuse_score/run.cpp: see bench/fuse_score/run.hpp.
#include "bench/fuse_score/run.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::score {
namespace {

using play::PlayLog;

constexpr double kTickPeriod = 1.0 / 30.0;
constexpr double kWarmUp = 1.0;       // s
constexpr double kNeededFor = 1.0;    // s
constexpr double kObservedFor = 0.1;  // s
constexpr double kFalseFor = 0.5;     // s
constexpr double kOutFor = 1.0;       // s; a ball out of play counts again after that

/// Outside of the lines; it comes back as nobody can foresee.
bool is_out_of_play(const play::TrueBall& ball) {
  const FieldModel field = play::play_field();
  return std::abs(ball.p_F.x()) > 0.5 * field.length || std::abs(ball.p_F.y()) > 0.5 * field.width;
}

/// Which opponents and which ball were shown by the frames delivered by `t`.
class Shown {
 public:
  explicit Shown(const PlayLog& log) : log_(log), players_(log.moments[0].players.size(), -1e9) {}

  void take_until(double t) {
    for (; next_ < log_.deliveries.size() && log_.deliveries[next_].arrival <= t; ++next_) {
      take(log_.frames[log_.deliveries[next_].frame]);
    }
  }

  void fill(Tick& tick) const {
    const auto own = static_cast<std::size_t>(log_.scenario.play.own);
    for (std::size_t i = own; i < players_.size(); ++i) {
      tick.needed.push_back(tick.t - players_[i] <= kNeededFor);
    }
    for (const auto& [robot, t] : ball_) {
      if (tick.t - t <= kObservedFor) ++tick.ball_observers;
      if (tick.t - t <= kNeededFor) tick.counts_ball = true;
    }
  }

 private:
  void take(const play::Frame& frame) {
    for (std::size_t i = 0; i < players_.size(); ++i) {
      if ((frame.seen_players >> i & 1U) == 0) continue;
      players_[i] = std::max(players_[i], frame.exposure);
    }
    if ((frame.seen_balls & 1U) != 0) ball_[frame.observation.id.robot] = frame.exposure;
  }

  const PlayLog& log_;
  std::vector<double> players_;
  std::map<int, double> ball_;
  std::size_t next_{0};
};

/// The bound of what was delivered, tick by tick.
///
/// Frames are taken in the order of exposure: those that nothing earlier can follow any more into
/// one filter, the rest, as far as they have arrived, into a copy of it.
class Delivered {
 public:
  explicit Delivered(const PlayLog& log)
      : log_(log),
        longest_(log.scenario.network.processing + log.scenario.network.max_delay),
        arrival_(log.frames.size(), kNeverArrived),
        settled_(log) {
    for (const auto& delivery : log.deliveries) {
      arrival_[delivery.frame] = std::min(arrival_[delivery.frame], delivery.arrival);
    }
  }

  BallBound bound_at(double t) {
    for (; next_ < log_.frames.size() && log_.frames[next_].exposure <= t - longest_; ++next_) {
      if (arrival_[next_] < kNeverArrived) settled_.take(log_.frames[next_]);
    }
    BoundFilter present = settled_;
    for (std::size_t i = next_; i < log_.frames.size() && log_.frames[i].exposure <= t; ++i) {
      if (arrival_[i] <= t) present.take(log_.frames[i]);
    }
    return present.at(t);
  }

 private:
  static constexpr double kNeverArrived = 1e9;  // s

  const PlayLog& log_;
  double longest_;
  std::vector<double> arrival_;
  BoundFilter settled_;
  std::size_t next_{0};
};

}  // namespace

double begins_to_count(const play::Scenario& scenario) {
  double begin = kWarmUp;
  for (const auto& fault : scenario.faults) begin = std::max(begin, fault.from);
  return begin;
}

double squared_ball_error(const play::TrueBall& truth, const Eigen::Vector3d& p_F) {
  const Eigen::Vector3d gap = p_F - truth.p_F;
  return truth.is_flying ? gap.squaredNorm() : gap.head<2>().squaredNorm();
}

void count_needed(const Tick& tick, BallTally& tally) {
  ++tally.needed;
  if (!tick.bound) return;
  tally.bound_position.add(tick.bound->var_position);
  tally.bound_velocity.add(tick.bound->var_velocity);
}

std::vector<Tick> make_ticks(const PlayLog& log) {
  Shown shown(log);
  std::optional<Delivered> delivered;
  if (log.has_known_errors) delivered.emplace(log);
  double last_out = -kOutFor;
  std::vector<Tick> ticks;
  const auto count = static_cast<int>(log.moments.back().t / kTickPeriod) - 1;
  for (int i = 1; i <= count; ++i) {
    Tick tick;
    tick.t = i * kTickPeriod;
    shown.take_until(tick.t);
    shown.fill(tick);
    if (delivered) {
      tick.bound = delivered->bound_at(tick.t);
      tick.counts_ball = tick.bound->is_known;
    }
    if (is_out_of_play(log.at(tick.t).balls[0])) last_out = tick.t;
    if (tick.t - last_out < kOutFor) tick.counts_ball = false;
    ticks.push_back(tick);
  }
  return ticks;
}

void IdBook::take_false(std::uint32_t id, double t) {
  const double since = false_since_.try_emplace(id, t).first->second;
  if (t - since < kFalseFor || is_counted_[id]) return;
  is_counted_[id] = true;
  ++false_tracks_;
}

void IdBook::take_true(std::uint32_t id, int truth) {
  false_since_.erase(id);
  const auto [known, is_new] = id_of_.try_emplace(truth, id);
  if (is_new || known->second == id) return;
  known->second = id;
  ++switches_;
}

void IdBook::take(const std::vector<std::uint32_t>& ids,
                  const std::vector<int>& truth_of,
                  double t) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] == 0) continue;
    if (truth_of[i] < 0) {
      take_false(ids[i], t);
    } else {
      take_true(ids[i], truth_of[i]);
    }
  }
}

namespace {

void count_ball(const Tick& tick,
                const play::TrueBall& truth,
                const peers::BallGuess& guess,
                double ball_radius,
                BallTally& tally) {
  const Eigen::Vector3d p_F(guess.p_F.x(), guess.p_F.y(), ball_radius);
  tally.position.add(squared_ball_error(truth, p_F));
  tally.velocity.add((guess.v_F - truth.v_F.head<2>()).squaredNorm() +
                     (truth.is_flying ? truth.v_F.z() * truth.v_F.z() : 0.0));
  if (truth.is_flying && tick.ball_observers >= 2) {
    tally.high.add((p_F - truth.p_F).squaredNorm());
  }
}

}  // namespace

std::vector<Scored> run_ball_rules(const PlayLog& log, const std::vector<Tick>& ticks) {
  peers::BallBook book(log.scenario.play.ball_radius);
  std::vector<Scored> scored;
  scored.reserve(peers::kBallRules.size());
  for (const peers::BallRule rule : peers::kBallRules) scored.push_back({name_of(rule), {}});
  const double begin = begins_to_count(log.scenario);
  std::size_t next = 0;
  for (const Tick& tick : ticks) {
    for (; next < log.deliveries.size() && log.deliveries[next].arrival <= tick.t; ++next) {
      const fusion::Observation observation = log.observation(log.deliveries[next]);
      book.take(observation, to_seconds(observation.exposure - play::host_time(0.0)));
    }
    if (tick.t < begin || !tick.counts_ball) continue;
    for (std::size_t i = 0; i < scored.size(); ++i) {
      BallTally& tally = scored[i].tally.ball;
      count_needed(tick, tally);
      const auto guess = book.ball(peers::kBallRules[i], tick.t);
      if (!guess) continue;
      count_ball(tick, log.at(tick.t).balls[0], *guess, log.scenario.play.ball_radius, tally);
    }
  }
  return scored;
}

namespace {

template <class Rule>
Tally run_obstacle_rule(const PlayLog& log, const std::vector<Tick>& ticks) {
  Rule rule;
  Tally tally;
  IdBook ids;
  const auto own = static_cast<std::size_t>(log.scenario.play.own);
  const double begin = begins_to_count(log.scenario);
  std::size_t next = 0;
  for (const Tick& tick : ticks) {
    for (; next < log.deliveries.size() && log.deliveries[next].arrival <= tick.t; ++next) {
      const fusion::Observation observation = log.observation(log.deliveries[next]);
      rule.take(observation,
                to_seconds(observation.exposure - play::host_time(0.0)),
                log.scenario.play.robot_radius);
    }
    if (tick.t < begin) continue;
    std::vector<Eigen::Vector2d> truths;
    const play::Moment& moment = log.at(tick.t);
    for (std::size_t i = own; i < moment.players.size(); ++i) {
      truths.push_back(moment.players[i].X_FR.origin().vector());
    }
    std::vector<Eigen::Vector2d> estimates;
    std::vector<std::uint32_t> names;
    for (const peers::ObstacleGuess& guess : rule.obstacles(tick.t)) {
      estimates.push_back(guess.p_F);
      names.push_back(guess.id);
    }
    const GospaMatch match = match_gospa(truths, tick.needed, estimates);
    count_gospa(match, tally.obstacles);
    ids.take(names, match.truth_of, tick.t);
  }
  tally.obstacles.switches = ids.switches();
  tally.obstacles.false_tracks = ids.false_tracks();
  tally.minutes = (ticks.back().t - begin) / 60.0;
  return tally;
}

}  // namespace

void count_gospa(const GospaMatch& match, ObstacleTally& tally) {
  tally.gospa.add(match.gospa.squared());
  tally.missed.add(match.gospa.missed);
  tally.false_ones.add(match.gospa.false_ones);
  tally.localisation.sum += match.gospa.localisation;
  tally.localisation.count += match.gospa.matched;
}

std::vector<Scored> run_obstacle_rules(const PlayLog& log, const std::vector<Tick>& ticks) {
  return {{"information-filter", run_obstacle_rule<peers::InformationFilterObstacles>(log, ticks)},
          {"two-witnesses", run_obstacle_rule<peers::TwoWitnessObstacles>(log, ticks)}};
}

}  // namespace teamsight::score
