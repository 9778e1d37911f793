// fusion/ball_motion.hpp: the ways in which a ball moves, each as one step of a filter.
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

namespace teamsight::fusion {

/// (x, y, z, vx, vy, vz) of the ball's centre in F; m, m/s.
using BallVector = Eigen::Matrix<double, 6, 1>;
using BallMatrix = Eigen::Matrix<double, 6, 6>;

/// By itself on the floor, above it, or on the floor and not by itself.
enum class BallMode : std::uint8_t { kRolling, kFlying, kLed };
inline constexpr std::size_t kBallModes = 3;

/// What balls do; SI.
struct BallMotion {
  double radius{0.11};        ///< m; it lies this high
  double friction{0.45};      ///< m/s^2 on carpet; middle of 0.3 to 0.6
  double rolling_psd{0.02};   ///< m^2/s^3: carpet is uneven
  double led_psd{0.6};        ///< m^2/s^3, of one that is led: by a robot, a foot, a string
  double leads_at_foot{1.0};  ///< per second: how soon a robot that touches a ball leads it
  double leads_alone{0.01};   ///< per second, of any ball, whoever is near
  double leads_end{1.0};      ///< per second: how soon one that is led rolls by itself again
  double flying_psd{0.3};     ///< m^2/s^3
  double gravity{9.81};       ///< m/s^2
  double drag{0.012};         ///< 1/m
  double climb_kept{0.65};    ///< of the vertical speed at a bounce
  double speed_kept{0.8};     ///< of the horizontal speed at a bounce
  double bounce_doubt{0.15};  ///< of the speed: what a bounce does besides
  double least_climb{0.4};    ///< m/s: a bounce that leaves less ends on the floor
  double kicks_at_foot{6.0};  ///< per second, of a ball that a robot touches
  double kicks_alone{0.005};  ///< per second, of any ball, whoever is near: nobody can know of all
  double kicks_in_play{0.5};  ///< per second, of any ball while nobody says anything at all
  double stopping_way{0.25};  ///< m; after so much on its way into a robot it is on its way back
  double high_share{0.1};     ///< of all games' kicks; the others go along the floor
  double high_share_weight{4.0};  ///< kicks of this game that weigh as much as `high_share`
  double kick_memory{50.0};       ///< kicks of this game that count
  double foot_reach{0.25};   ///< m from a robot's body to the centre of a ball that it can kick
  double foot_height{0.5};   ///< m: no foot reaches higher
  double sigma_pass{2.5};    ///< m/s per floor component, of the velocity after a soft kick
  double sigma_shot{6.0};    ///< ... after a hard one
  double shot_share{0.4};    ///< hard ones among the kicks along the floor
  double sigma_high{4.0};    ///< m/s per floor component, after a kick into the air
  double climb{3.0};         ///< m/s, of the vertical velocity after a high kick
  double sigma_climb{2.0};   ///< m/s
  double fastest{12.0};      ///< m/s; no robot's kick is faster
  double sigma_floor{0.01};  ///< m, of the height of one that rolls
  /// At the edge of the carpet there is a board, a net, a person: a ball comes back slower.
  Eigen::Vector2d carpet_centre{0.0, 0.0};  ///< in F; m
  Eigen::Vector2d carpet_reach{1e3, 1e3};   ///< half its length and width; m
  double rebound_kept{0.4};   ///< of the speed towards the edge: between none and most
  double rebound_doubt{0.3};  ///< of the speed: what the edge does besides
};

/// One step of one mode: where the mean goes, how errors go, and what is added to them.
struct BallStep {
  BallVector mean;
  BallMatrix transition;
  BallMatrix disturbance;
  bool lands{false};  ///< it flew, and rolls from now on
};

/// @param dt  s, above 0
[[nodiscard]] BallStep step_rolling(const BallVector& mean,
                                    double dt,
                                    double psd,
                                    const BallMotion& motion);

/// On the floor, wherever something leads it: not braked.
///
/// @param dt  s, above 0
[[nodiscard]] BallStep step_led(const BallVector& mean, double dt, const BallMotion& motion);

/// What is added to the covariance of one that is led since an unknown instant of the last `dt`
/// (s).
[[nodiscard]] BallMatrix led_for_a_part(double dt, const BallMotion& motion);

/// Ballistic with drag; bounces where it would come through the floor.
[[nodiscard]] BallStep step_flying(const BallVector& mean, double dt, const BallMotion& motion);

/// One that has left the carpet: back on its edge, on its way inwards.
///
/// @return nothing if it is on the carpet
[[nodiscard]] std::optional<BallStep> step_rebound(const BallVector& mean,
                                                   const BallMotion& motion);

/// What a kick makes of a ball.
struct Kick {
  BallMode into{BallMode::kRolling};
  /// Mean of the unit vector away from the foot, times the probability that a foot kicks; zero: a
  /// kick into any direction. No robot kicks through its own body.
  Eigen::Vector2d away{Eigen::Vector2d::Zero()};
  double sigma{0.0};  ///< of the velocity afterwards, per floor component; m/s
};

/// A kick at an unknown instant of the last `dt`: the velocity afterwards says nothing of the one
/// before, and how far it has led is as uncertain as when it began.
///
/// @param mean  where the ball would be without it
[[nodiscard]] BallStep step_kicked(const BallVector& mean,
                                   double dt,
                                   const Kick& kick,
                                   const BallMotion& motion);

}  // namespace teamsight::fusion
