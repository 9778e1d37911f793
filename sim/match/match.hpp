// sim/match/match.hpp: a match as a value: the same scenario gives the same motion.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/field_model.hpp"
#include "geometry/identity.hpp"
#include "sim/match/ball.hpp"
#include "sim/match/pitch.hpp"
#include "sim/match/play.hpp"
#include "sim/match/players.hpp"
#include "sim/match/random.hpp"
#include "sim/match/script.hpp"

namespace teamsight::sim {

/// What may happen in a match, and what will.
struct MatchParameters {
  std::uint32_t seed{1};
  std::vector<RobotId> own;    ///< at least one, no id twice
  std::uint32_t opponents{5};  ///< at most 15
  BallParameters ball;
  BodyParameters body;
  PlayStyle style;
  std::vector<ScriptLine> script;  ///< in any order; lines of one time happen in theirs
};

/// Two teams and a ball. Goes on in steps of fixed length and has no other source of chance than
/// the seed, so that copies stay equal for ever.
class Match {
 public:
  /// Length of one step; s.
  static constexpr double kStep = 0.01;

  /// Everybody stands in the own half, drawn at random, the ball in the centre; then the script's
  /// lines of time 0 happen.
  Match(MatchParameters parameters, const FieldModel& field);

  /// Goes on to `seconds` after the start, in whole steps; never back.
  void advance_to(double seconds);

  [[nodiscard]] const MatchState& state() const { return state_; }

  /// Seconds since the start.
  [[nodiscard]] double time() const { return static_cast<double>(steps_) * kStep; }

 private:
  void step();
  void place(std::uint8_t number, double side);
  void follow_script();
  void happen(const Happening& happening);
  [[nodiscard]] std::size_t index_of(std::uint8_t number) const;
  void move_players();
  void move_ball(Ball& ball);
  void dribble(Ball& ball, const Player& holder);
  void change_holder(Ball& ball);
  void tackle(Ball& ball, const Player& player);
  [[nodiscard]] bool can_hold(const Ball& ball, const Player& player) const;
  void release(Ball& ball, const Velocity3<Field>& v_FB);
  void bring_back(Ball& ball);

  MatchParameters parameters_;
  Pitch pitch_;
  Random random_;
  Play play_;
  std::uint64_t steps_{0};
  std::size_t line_{0};  // of the script, the next one
  MatchState state_;
  std::vector<std::optional<Point<Field>>> sent_to_;  // per player, by the script
  std::vector<double> may_hold_at_;                   // per player; s
  double dead_for_{0.0};                              // s that the ball lies outside
};

}  // namespace teamsight::sim
