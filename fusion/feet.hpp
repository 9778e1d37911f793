// fusion/feet.hpp: who may kick a ball: the robots that are known, and how near they stand.
#pragma once

#include <Eigen/Core>

#include "fusion/inline_list.hpp"
#include "fusion/unseen.hpp"

namespace teamsight::fusion {

/// A robot of either team, as a disc that may touch a ball.
struct Feet {
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};  ///< of its centre; m
  double var{0.0};                               ///< of p_F, per coordinate; m^2
  double radius{0.0};                            ///< m
};

/// All teammates and obstacles that can be known at once.
inline constexpr std::size_t kMaxFeet = kMaxRobotId + 24;
using FeetList = InlineList<Feet, kMaxFeet>;

/// Who may kick a ball: the robots that are known, and those that nobody has seen yet.
struct Kickers {
  FeetList known;
  const UnseenMap* unseen{nullptr};  ///< where the others may stand; none: there are no others
  Carpet carpet;                     ///< that the map lies over
  double density{0.0};               ///< of the others where nobody ever looked, per m^2
  double radius{0.25};               ///< of their bodies; m
  /// Nobody has said anything for a while: whoever was known may be elsewhere, and robots go for
  /// the ball.
  bool is_silence{false};
};

/// The robot that most likely touches a ball.
struct Touch {
  /// That it does, in [0, 1].
  double probability{0.0};
  /// Mean of the unit vector from it to the ball, in F.
  Eigen::Vector2d away{Eigen::Vector2d::Zero()};
};

/// Where a ball may be on the floor.
struct BallPlace {
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};  ///< m
  double var{0.0};                               ///< per coordinate; m^2
};

/// @param reach  how far a robot's foot reaches from its body to the ball's centre; m
[[nodiscard]] Touch likeliest_touch(const BallPlace& ball, const FeetList& feet, double reach);

/// That a robot of which nobody knows touches the ball, in [0, 1].
[[nodiscard]] double unseen_touch(const BallPlace& ball, const Kickers& kickers, double reach);

}  // namespace teamsight::fusion
