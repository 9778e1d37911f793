// bench/fuse_score/run.hpp: fusion and the peers' rules over one play, beside the truth.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/fuse_score/bound.hpp"
#include "bench/fuse_score/tally.hpp"
#include "bench/peers/ball_rules.hpp"
#include "bench/peers/obstacle_rules.hpp"
#include "bench/play/play_log.hpp"
#include "fusion/fusion.hpp"

namespace teamsight::score {

/// One estimator's result.
struct Scored {
  std::string estimator;
  Tally tally;
};

/// When worlds are compared with the truth: 30 times a second.
struct Tick {
  double t{0.0};
  /// The first ball is in play and could be known: by the bound or, where there is none, because a
  /// delivered frame of the last second shows it.
  bool counts_ball{false};
  std::optional<BallBound> bound;  ///< of what was delivered by then, where errors are known
  std::vector<bool> needed;  ///< for each opponent: shown by a delivered frame of the last second
  int ball_observers{0};     ///< robots whose frames of the last 0.1 s show the first ball
};

[[nodiscard]] std::vector<Tick> make_ticks(const play::PlayLog& log);

/// @param without_bad  leaves the frames of robots with a fault out
[[nodiscard]] Tally run_fusion(const play::PlayLog& log,
                               const std::vector<Tick>& ticks,
                               bool without_bad);

/// Every peer rule for the ball.
[[nodiscard]] std::vector<Scored> run_ball_rules(const play::PlayLog& log,
                                                 const std::vector<Tick>& ticks);

/// Every peer rule for obstacles.
[[nodiscard]] std::vector<Scored> run_obstacle_rules(const play::PlayLog& log,
                                                     const std::vector<Tick>& ticks);

/// From when on ticks count: after a second, or when the first fault has begun.
[[nodiscard]] double begins_to_count(const play::Scenario& scenario);

/// Counts a tick at which the ball could be known.
void count_needed(const Tick& tick, BallTally& tally);

/// Squared error of a ball, with its height while it flies.
[[nodiscard]] double squared_ball_error(const play::TrueBall& truth, const Eigen::Vector3d& p_F);

/// Adds one tick's match to the tally.
void count_gospa(const GospaMatch& match, ObstacleTally& tally);

/// Follows under which ids the opponents are known.
class IdBook {
 public:
  /// @param t  s
  void take(const std::vector<std::uint32_t>& ids, const std::vector<int>& truth_of, double t);

  [[nodiscard]] int switches() const { return switches_; }

  [[nodiscard]] int false_tracks() const { return false_tracks_; }

 private:
  void take_false(std::uint32_t id, double t);
  void take_true(std::uint32_t id, int truth);

  std::map<int, std::uint32_t> id_of_;
  std::map<std::uint32_t, double> false_since_;
  std::map<std::uint32_t, bool> is_counted_;
  int switches_{0};
  int false_tracks_{0};
};

}  // namespace teamsight::score
