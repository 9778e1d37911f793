// sim/match/play.hpp: what the players of both teams decide.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/match/pitch.hpp"
#include "sim/match/players.hpp"
#include "sim/match/random.hpp"

namespace teamsight::sim {

/// How both teams play.
struct PlayStyle {
  bool plays{true};            ///< false: everybody stands, except where a script sends them
  double shortest_hold{0.4};   ///< of the ball, before it is kicked; s
  double longest_hold{2.5};    ///< s
  double shot_share{0.3};      ///< of the kicks that are shots, when near enough to a goal
  double shot_range{9.0};      ///< from the goal; m
  double slowest_shot{7.0};    ///< m/s
  double fastest_shot{10.0};   ///< m/s
  double lofted_share{0.25};   ///< of all kicks that leave the floor
  double steepest_loft{0.7};   ///< rad; the flattest is a third of it
  double pass_arrival{1.5};    ///< speed that a pass is to have where it is aimed at; m/s
  double formation_size{1.0};  ///< of the lines; smaller crowds everybody around the ball
};

/// A kick that a player wants to give the ball that it holds.
struct Kick {
  Velocity3<Field> v_FB;  ///< m/s
};

/// Both teams' heads: nearest hunts, holder dribbles and kicks, the others take their places.
class Play {
 public:
  /// @param players  how many there are
  Play(const PlayStyle& style, std::size_t players);

  struct Decision {
    Intention intention;
    std::optional<Kick> kick;
  };

  /// Decides for everybody on the field, for the next step.
  ///
  /// @param time  since the start; s
  /// @return one decision per player, valid until the next call
  [[nodiscard]] const std::vector<Decision>& decide(const MatchState& state,
                                                    const Pitch& pitch,
                                                    const BodyParameters& body,
                                                    double time,
                                                    Random& random);

 private:
  struct Plan {
    double wander_until{0.0};          // s
    Eigen::Vector2d wander{0.0, 0.0};  // from its place in the formation; m
    double kick_at{-1.0};              // s; negative: not decided
    Point<Field> aim;
    double speed{0.0};  // of the kick; m/s
    double loft{0.0};   // rad
  };

  /// What the others need to know of one step.
  struct Moment {
    const MatchState& state;
    const Pitch& pitch;
    const BodyParameters& body;
    double time;
  };

  void hold(std::size_t player, const Moment& moment, Random& random);
  void plan_kick(std::size_t player, const Moment& moment, Random& random);
  [[nodiscard]] std::optional<std::size_t> draw_mate(std::size_t player,
                                                     const Moment& moment,
                                                     Random& random) const;
  void hunt(std::size_t player, const Moment& moment);
  void take_place(std::size_t player, const Moment& moment, Random& random);
  [[nodiscard]] Point<Field> place_of(std::size_t player, const Moment& moment) const;

  PlayStyle style_;
  std::vector<Plan> plans_;
  std::vector<Decision> decisions_;
};

}  // namespace teamsight::sim
