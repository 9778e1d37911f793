// fusion/feet.hpp: who may kick a ball: the robots that are known, and how near they stand.
#pragma once

#include <Eigen/Core>

#include "fusion/inline_list.hpp"

namespace teamsight::fusion {

/// A robot of either team, as a disc that may touch a ball.
struct Feet {
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};  ///< of its centre; m
  double var{0.0};                               ///< of p_F, per coordinate; m^2
  double radius{0.0};                            ///< m
};

/// All teammates and obstacles that can be known at once.
inline constexpr std::size_t kMaxFeet = 40;
using FeetList = InlineList<Feet, kMaxFeet>;

/// The robot that most likely touches a ball.
struct Touch {
  /// That it does, in [0, 1].
  double probability{0.0};
  /// Mean of the unit vector from it to the ball, in F.
  Eigen::Vector2d away{Eigen::Vector2d::Zero()};
};

/// @param ball_F  the ball's place; m
/// @param ball_var  of its place, per coordinate; m^2
/// @param reach  how far a robot's foot reaches from its body to the ball's centre; m
[[nodiscard]] Touch likeliest_touch(const Eigen::Vector2d& ball_F,
                                    double ball_var,
                                    const FeetList& feet,
                                    double reach);

}  // namespace teamsight::fusion
