// bench/fuse_score/run_fusion.cpp: fusion over one play (bench/fuse_score/run.hpp).
#include <algorithm>
#include <chrono>

#include "bench/fuse_score/run.hpp"
#include "bench/fuse_score/shared_evidence.hpp"
#include "fusion/teammate.hpp"
#include "geometry/angle.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::score {
namespace {

using play::PlayLog;

constexpr double kWrong = 0.3;     // m
constexpr double kEndedFor = 1.0;  // s without a wrong posture: the fault is over

/// One run of fusion, tick by tick.
class FusionRun {
 public:
  FusionRun(const PlayLog& log, const std::vector<Tick>& ticks, bool without_bad)
      : log_(log),
        ticks_(ticks),
        without_bad_(without_bad),
        begin_(begins_to_count(log.scenario)),
        fusion_(parameters(log), play::play_field()) {}

  Tally run() {
    for (const Tick& tick : ticks_) {
      deliver_until(tick.t);
      const HostTime now = play::host_time(tick.t);
      // As the service does while it leads: names stay as they were said.
      fusion_.adopt_ids(world_, last_);
      world_ = fusion_.world_at(now);
      last_ = now;
      watch_trust(tick);
      if (tick.t < begin_) continue;
      count_ball(tick);
      count_obstacles(tick);
      count_mates(tick);
    }
    finish();
    return tally_;
  }

 private:
  static fusion::Parameters parameters(const PlayLog& log) {
    fusion::Parameters parameters;
    parameters.ball_radius = log.scenario.play.ball_radius;
    parameters.robot_radius = log.scenario.play.robot_radius;
    return parameters;
  }

  [[nodiscard]] const play::FaultPlan* fault_of(RobotId robot) const {
    for (const play::FaultPlan& plan : log_.scenario.faults) {
      if (plan.robot == robot) return &plan;
    }
    return nullptr;
  }

  void deliver_until(double t) {
    for (; next_ < log_.deliveries.size() && log_.deliveries[next_].arrival <= t; ++next_) {
      const fusion::Observation observation = log_.observation(log_.deliveries[next_]);
      if (without_bad_ && fault_of(observation.id.robot) != nullptr) continue;
      const auto before = std::chrono::steady_clock::now();
      fusion_.insert(observation, play::host_time(log_.deliveries[next_].arrival));
      const std::chrono::duration<double, std::micro> took =
          std::chrono::steady_clock::now() - before;
      tally_.insert_us.add(took.count());
      const play::Frame& frame = log_.frames[log_.deliveries[next_].frame];
      const auto robot = static_cast<std::size_t>(observation.id.robot);
      const Eigen::Vector2d truth =
          log_.at(frame.exposure).players[robot - 1].X_FR.origin().vector();
      const double off = (observation.posture.X_FR.origin().vector() - truth).norm();
      said_[observation.id.robot] = off * off;
      const PostureEstimate& posture = observation.posture;
      const bool is_used =
          fusion::is_resolved(posture.status, posture.half_log_odds, parameters(log_).teammate);
      if (is_used && off > kWrong) {
        wrong_until_[observation.id.robot] = frame.exposure;
      }
    }
  }

  void count_ball(const Tick& tick) {
    if (!tick.counts_ball) return;
    BallTally& tally = tally_.ball;
    count_needed(tick, tally);
    if (world_.balls.empty()) return;
    if (log_.scenario.play.balls == 1 && world_.balls.size() > 1) ++tally.second_balls;
    const play::TrueBall& truth = log_.at(tick.t).balls[0];
    const WorldBall* chosen = chosen_ball(log_.at(tick.t).balls);
    if (chosen == nullptr) return;
    const WorldBall& ball = *chosen;
    const Eigen::Vector3d error = ball.p_FB.vector() - truth.p_F;
    const Eigen::Vector3d error_v = ball.v_FB.vector() - truth.v_F;
    tally.position.add(squared_ball_error(truth, ball.p_FB.vector()));
    const int n = truth.is_flying ? 3 : 2;
    tally.velocity.add(error_v.head(n).squaredNorm());
    tally.nees_position.add(squared_mahalanobis(error.head(n), ball.cov_p.topLeftCorner(n, n)) / n);
    tally.nees_velocity.add(squared_mahalanobis(error_v.head(n), ball.cov_v.topLeftCorner(n, n)) /
                            n);
    if (!truth.is_flying || tick.ball_observers < 2) return;
    tally.high.add(error.squaredNorm());
    if (tick.bound) tally.bound_high.add(tick.bound->var_position);
  }

  /// The most probable one; with two true balls, the best of those listed that are nearer to the
  /// first than to the second. Nothing if the second alone is listed: the first one is not known
  /// then.
  [[nodiscard]] const WorldBall* chosen_ball(const std::vector<play::TrueBall>& truths) const {
    if (truths.size() == 1) return &world_.balls[0];
    const WorldBall* best = nullptr;
    double nearest = 1e9;
    for (const WorldBall& ball : world_.balls) {
      const double to_first = (ball.p_FB.vector() - truths[0].p_F).head<2>().norm();
      const double to_second = (ball.p_FB.vector() - truths[1].p_F).head<2>().norm();
      if (to_first > to_second || to_first >= nearest) continue;
      best = &ball;
      nearest = to_first;
    }
    return best;
  }

  void count_obstacles(const Tick& tick) {
    const play::Moment& moment = log_.at(tick.t);
    std::vector<Eigen::Vector2d> truths;
    for (const play::TruePlayer& player : moment.players) {
      if (player.robot == kNobody) truths.push_back(player.X_FR.origin().vector());
    }
    std::vector<Eigen::Vector2d> estimates;
    std::vector<std::uint32_t> names;
    for (const WorldObstacle& obstacle : world_.obstacles) {
      estimates.push_back(obstacle.p_FO.vector());
      names.push_back(obstacle.track);
    }
    const GospaMatch match = match_gospa(truths, tick.needed, estimates);
    count_gospa(match, tally_.obstacles);
    ids_.take(names, match.truth_of, tick.t);
    for (std::size_t i = 0; i < estimates.size(); ++i) {
      if (match.truth_of[i] < 0) continue;
      const auto truth = static_cast<std::size_t>(match.truth_of[i]);
      if (!tick.needed[truth]) continue;
      tally_.obstacles.nees.add(
          0.5 * squared_mahalanobis(estimates[i] - truths[truth], world_.obstacles[i].cov_p));
    }
  }

  void count_mates(const Tick& tick) {
    const play::Moment& moment = log_.at(tick.t);
    for (const WorldTeammate& mate : world_.teammates) {
      if (fault_of(mate.robot) != nullptr || mate.status != PostureStatus::kOk ||
          mate.age > std::chrono::milliseconds(500)) {
        continue;
      }
      const auto& truth = moment.players[static_cast<std::size_t>(mate.robot) - 1].X_FR;
      const Eigen::Vector3d error(mate.X_FR.x() - truth.x(),
                                  mate.X_FR.y() - truth.y(),
                                  angle_difference(mate.X_FR.theta(), truth.theta()));
      tally_.mates.position.add(error.head<2>().squaredNorm());
      tally_.mates.nees.add(squared_mahalanobis(error, mate.cov) / 3.0);
      tally_.mates.said.add(said_[mate.robot]);
    }
  }

  void watch_trust(const Tick& tick) {
    for (const WorldTeammate& mate : world_.teammates) {
      const bool is_out = mate.quarantine != Quarantine::kNone;
      const play::FaultPlan* fault = fault_of(mate.robot);
      const bool was_out = is_out_[mate.robot];
      is_out_[mate.robot] = is_out;
      if (!is_out || was_out) continue;
      if (fault == nullptr || tick.t < fault->from) {
        ++tally_.trust.false_alarms;
        continue;
      }
      if (!found_.try_emplace(mate.robot, tick.t - fault->from).second) continue;
      if (!is_right_reason(fault->fault, mate.quarantine)) ++tally_.trust.wrong_reason;
    }
  }

  static bool is_right_reason(play::Fault fault, Quarantine reason) {
    switch (fault) {
      case play::Fault::kMirrored:
        return reason == Quarantine::kMirrored;
      case play::Fault::kBiased:
        return reason == Quarantine::kBiased;
      case play::Fault::kKidnapped:
        return reason == Quarantine::kKidnapped || reason == Quarantine::kBiased;
      case play::Fault::kNone:
        break;
    }
    return false;
  }

  void count_found(const play::FaultPlan& plan) {
    const double wrong_for = wrong_until_[plan.robot] - plan.from;
    const auto found = found_.find(plan.robot);
    const bool is_over = ticks_.back().t - wrong_until_[plan.robot] > kEndedFor;
    if (is_over) tally_.trust.over_after.push_back(std::max(0.0, wrong_for));
    if (found != found_.end()) {
      tally_.trust.found_after.push_back(found->second);
      tally_.trust.found_after_evidence.push_back(
          shared_evidence_until(log_, plan, plan.from + found->second));
    } else if (!is_over) {
      ++tally_.trust.not_found;
    }
  }

  void finish() {
    for (const play::FaultPlan& plan : log_.scenario.faults) {
      count_found(plan);
    }
    tally_.obstacles.switches = ids_.switches();
    tally_.obstacles.false_tracks = ids_.false_tracks();
    tally_.minutes = (ticks_.back().t - begin_) / 60.0;
  }

  const PlayLog& log_;
  const std::vector<Tick>& ticks_;
  bool without_bad_;
  double begin_;
  fusion::Fusion fusion_;
  std::size_t next_{0};
  WorldModel world_;
  HostTime last_{play::host_time(0.0)};
  Tally tally_;
  IdBook ids_;
  std::map<int, double> said_;         // squared error of the last posture, when it was true
  std::map<int, double> wrong_until_;  // s; exposure of the last posture that was
  std::map<int, bool> is_out_;
  std::map<int, double> found_;
};

}  // namespace

Tally run_fusion(const PlayLog& log, const std::vector<Tick>& ticks, bool without_bad) {
  return FusionRun(log, ticks, without_bad).run();
}

}  // namespace teamsight::score
