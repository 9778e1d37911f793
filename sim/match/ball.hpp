// sim/match/ball.hpp: how a ball rolls, flies and bounces.
#pragma once

#include <cstdint>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/frames.hpp"

namespace teamsight::sim {

/// One ball at one moment.
struct Ball {
  Point3<Field> p_FB;      ///< its centre
  Velocity3<Field> v_FB;   ///< m/s
  std::uint8_t holder{0};  ///< number of the player that dribbles it; 0: nobody
  /// How it is turned since it was put there, in F: it rolls where it goes, in the air as well.
  Eigen::Quaterniond turn_F{Eigen::Quaterniond::Identity()};

  friend bool operator==(const Ball&, const Ball&) = default;
};

/// What a ball of the league does on carpet and in air.
struct BallParameters {
  double radius{0.11};        ///< m
  double deceleration{0.45};  ///< rolling friction; m/s^2
  double drag{0.015};         ///< of the air: deceleration over the square of the speed; 1/m
  double bounce{0.65};        ///< share of the upward speed that is left after a bounce
  double grip{0.8};           ///< share of the speed along the floor that is left after a bounce
  double least_bounce{0.4};   ///< slower falls end on the floor; m/s
};

/// Whether the ball is in the air.
[[nodiscard]] bool is_flying(const Ball& ball, const BallParameters& parameters);

/// How a ball that was turned like `ball` and has gone from `before` to where it is has rolled.
[[nodiscard]] Eigen::Quaterniond rolled(const Ball& ball,
                                        const Point3<Field>& before,
                                        const BallParameters& parameters);

/// Moves a free ball over an endless floor.
///
/// @param seconds  at most some hundredths: it is integrated in steps of a millisecond in the air
[[nodiscard]] Ball moved(Ball ball, double seconds, const BallParameters& parameters);

}  // namespace teamsight::sim
