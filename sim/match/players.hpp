// sim/match/players.hpp: what players are, and how their bodies follow their wheels.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/frames.hpp"
#include "geometry/identity.hpp"
#include "geometry/pose.hpp"
#include "sim/match/ball.hpp"

namespace teamsight::sim {

/// Opponents are numbered from here on, as on the wire.
inline constexpr std::uint8_t kFirstOpponent = 17;

/// One player at one moment.
struct Player {
  std::uint8_t number{0};  ///< own: its robot id; opponents: 17 and up
  bool on_field{true};     ///< false: carried away; the rest then means nothing
  Pose<Field, Robot> X_FR;
  Velocity<Field> v_FR;      ///< of the body; m/s
  double omega{0.0};         ///< rad/s
  Velocity<Field> wheels_F;  ///< what the wheels turn; more or less than v_FR while they slip
  double slippery_for{0.0};  ///< s that its wheels go on having little grip

  [[nodiscard]] bool is_own() const { return number < kFirstOpponent; }
};

/// One moment of the match.
struct MatchState {
  std::vector<Player> players;  ///< own ones first; always the same, whoever is on the field
  std::vector<Ball> balls;      ///< at least one; the first is the one that is played
};

/// What bodies and wheels can do.
struct BodyParameters {
  double radius{0.25};                ///< m
  double height{0.8};                 ///< m; balls fly over it
  double max_speed{2.5};              ///< m/s
  double max_acceleration{2.5};       ///< of the wheels; m/s^2
  double max_turn{2.5};               ///< rad/s
  double max_turn_acceleration{6.0};  ///< rad/s^2
  double grip{4.0};                   ///< acceleration that the floor can give a body; m/s^2
  double slippery_grip{0.7};          ///< the same while wheels slip; m/s^2
  double slips_per_second{0.05};      ///< how often a player's wheels begin to slip; Hz
  double longest_slip{0.5};           ///< s
};

/// What a player wants to do now.
struct Intention {
  Eigen::Vector2d velocity_F{0.0, 0.0};  ///< m/s
  double heading{0.0};                   ///< to face; rad in F
};

/// Moves one player: its wheels follow the intention within their limits, its body follows its
/// wheels as far as the floor has grip.
void drive(Player& player,
           const Intention& intention,
           double seconds,
           const BodyParameters& parameters);

/// Pushes bodies that overlap apart; they stop moving towards each other, their wheels do not.
void keep_apart(std::vector<Player>& players, const BodyParameters& parameters);

/// The velocity with which to reach `target` and stop there, away from other players.
[[nodiscard]] Eigen::Vector2d velocity_to(const Point<Field>& target,
                                          std::size_t player,
                                          const std::vector<Player>& players,
                                          const BodyParameters& parameters);

/// Makes a free ball give way to the players' bodies and bounce off them.
void meet_players(Ball& ball,
                  const std::vector<Player>& players,
                  double ball_radius,
                  const BodyParameters& parameters);

}  // namespace teamsight::sim
