// bench/peers/ball_rules.hpp: how other teams make one ball of everybody's, to be compared with.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bench/peers/solo_ball.hpp"
#include "geometry/identity.hpp"

namespace teamsight::peers {

/// The rules, with the constants that their teams' public sources have.
enum class BallRule : std::uint8_t {
  kNearestObserver,     ///< CAMBADA, BigHeroX: the ball of the robot nearest to it
  kVoteWithinAMetre,    ///< Cassel: mean of the largest set within 1 m, seen within 0.3 s
  kLowestCovariance,    ///< Bit-Bots: the ball of the robot that is surest, seen within 1 s
  kNewest,              ///< HULKs: the ball heard last, within 4.5 s
  kClusteredWeights,    ///< B-Human: weighted mean of the heaviest cluster within 0.777 m
  kProductOfGaussians,  ///< Falcons: product of Gaussians that are long along the ray, within 2 s
};

inline constexpr std::array<BallRule, 6> kBallRules = {BallRule::kNearestObserver,
                                                       BallRule::kVoteWithinAMetre,
                                                       BallRule::kLowestCovariance,
                                                       BallRule::kNewest,
                                                       BallRule::kClusteredWeights,
                                                       BallRule::kProductOfGaussians};

[[nodiscard]] std::string name_of(BallRule rule);

/// Every robot's own ball, from the same observations that fusion gets.
class BallBook {
 public:
  explicit BallBook(double ball_radius) : ball_radius_(ball_radius) {}

  /// @param t  exposure; s
  void take(const fusion::Observation& observation, double t);

  /// The rule's ball at `now`. Each robot's ball is first carried to `now` with the robot's own
  /// velocity and rolling friction: not all the teams do so, and without it all are worse.
  ///
  /// @return nothing if the rule has none
  [[nodiscard]] std::optional<BallGuess> ball(BallRule rule, double now) const;

 private:
  struct Vote {
    BallGuess guess;
    Eigen::Vector2d observer_F{Eigen::Vector2d::Zero()};
    double age{0.0};
    double distance{0.0};
    double variance{0.0};
  };

  using Votes = std::vector<Vote>;

  [[nodiscard]] Votes votes_at(double now, double max_age) const;

  double ball_radius_;
  std::array<SoloBall, kMaxRobotId> solos_;
};

}  // namespace teamsight::peers
