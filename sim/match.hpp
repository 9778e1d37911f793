// sim/match.hpp: a match as a value: the same seed gives the same motion.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "geometry/field_model.hpp"
#include "geometry/frames.hpp"
#include "geometry/identity.hpp"
#include "geometry/pose.hpp"

namespace teamsight::sim {

/// What may happen in a match.
struct MatchParameters {
  std::uint32_t seed{1};
  std::vector<RobotId> own;  ///< at least one
  std::uint32_t opponents{5};
  double ball_radius{0.11};           ///< m
  double robot_radius{0.25};          ///< m
  double max_speed{2.5};              ///< m/s
  double max_acceleration{2.5};       ///< m/s^2
  double max_turn{2.5};               ///< rad/s
  double max_turn_acceleration{6.0};  ///< rad/s^2
  double ball_deceleration{0.45};     ///< rolling friction; m/s^2
  double max_kick{5.0};               ///< m/s
};

/// One player at one moment.
struct Player {
  std::uint8_t number{0};  ///< own: its robot id; opponents: 17 and up
  Pose<Field, Robot> X_FR;
  Velocity<Field> v_FR;  ///< m/s
  double omega{0.0};     ///< rad/s
};

/// One moment of the match.
struct MatchState {
  std::vector<Player> players;  ///< own ones first
  Point3<Field> p_FB;           ///< ball centre
  Velocity3<Field> v_FB;
};

/// How long everybody stands before kick-off: agents that start with the match find themselves in
/// the half that their robot file says.
inline constexpr double kBeforeKickOff = 6.0;  // s

/// A scripted match: everybody runs to places drawn at random, the nearest of each team goes for
/// the ball and kicks it. Steps of fixed length, so that two copies stay equal for ever.
class Match {
 public:
  /// Length of one step; s.
  static constexpr double kStep = 0.01;

  /// @pre `parameters.own` is not empty
  Match(const MatchParameters& parameters, const FieldModel& field);

  /// Goes on to `seconds` after the start, in whole steps; never back.
  void advance_to(double seconds);

  [[nodiscard]] const MatchState& state() const { return state_; }

  /// Seconds since the start.
  [[nodiscard]] double time() const { return static_cast<double>(steps_) * kStep; }

 private:
  struct Plan {
    Point<Field> target;
    double until{0.0};        // s
    double may_kick_at{0.0};  // s
  };

  void step();
  void plan(std::size_t player);
  void drive(std::size_t player, const Point<Field>& target);
  void turn(Player& player) const;
  void keep_apart();
  void push_apart(Player& a, Player& b) const;
  void meet_ball(std::size_t player);
  void kick(std::size_t player);
  void roll();
  [[nodiscard]] std::size_t nearest_to_ball(std::size_t from, std::size_t to) const;
  [[nodiscard]] double uniform(double from, double to);

  MatchParameters parameters_;
  double half_length_;
  double half_width_;
  Point<Field> centre_;
  std::mt19937 random_;
  std::uint64_t steps_{0};
  MatchState state_;
  std::vector<Plan> plans_;
};

}  // namespace teamsight::sim
