// bench/play/play.hpp: a made-up game without cameras: true motion of robots and balls, by seed.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_model.hpp"
#include "geometry/frames.hpp"
#include "geometry/identity.hpp"
#include "geometry/pose.hpp"

namespace teamsight::play {

using Random = std::mt19937_64;

/// A draw from a normal distribution, the same on every machine that has this standard library.
[[nodiscard]] double normal(Random& random, double sigma);
[[nodiscard]] double uniform(Random& random, double from, double to);

struct TrueBall {
  Eigen::Vector3d p_F{Eigen::Vector3d::Zero()};  ///< centre; m
  Eigen::Vector3d v_F{Eigen::Vector3d::Zero()};  ///< m/s
  bool is_flying{false};
  std::uint32_t kicks{0};    ///< counts what changed its velocity at once: kicks and walls
  std::uint32_t bounces{0};  ///< counts bounces on the floor
};

struct TruePlayer {
  RobotId robot{kNobody};  ///< kNobody: an opponent
  Pose<Field, Robot> X_FR;
  Eigen::Vector2d v_F{Eigen::Vector2d::Zero()};  ///< m/s
  double omega{0.0};                             ///< rad/s
};

struct Moment {
  double t{0.0};                    ///< s since the start
  std::vector<TruePlayer> players;  ///< own ones first
  std::vector<TrueBall> balls;
};

/// What may happen in a play.
struct PlayParameters {
  int own{5};
  int opponents{5};
  int balls{1};
  double min_kick{1.5};    ///< m/s
  double max_kick{5.0};    ///< m/s
  double high_share{0.0};  ///< of the kicks; those leave the floor
  bool is_crowd{false};    ///< everybody stays within 3 m of the ball
  double ball_radius{0.11};
  double robot_radius{0.25};
};

/// Everybody runs to places drawn at random; of each team the nearest goes for the ball and kicks
/// it on arrival. Rolling: 0.45 m/s^2 of friction; flying: drag 0.012/m; bounces keep 0.65 of the
/// climb and 0.8 of the rest. At the edge of the carpet a wall sends it back at half its speed.
/// Steps of 10 ms.
class Play {
 public:
  static constexpr double kStep = 0.01;       // s
  static constexpr double kClimbKept = 0.65;  ///< of the vertical speed at a bounce
  static constexpr double kSpeedKept = 0.8;   ///< of the horizontal speed at a bounce

  Play(const PlayParameters& parameters, const FieldModel& field, std::uint64_t seed);

  void step();

  [[nodiscard]] const Moment& moment() const { return moment_; }

 private:
  void choose_target(std::size_t player);
  void drive(std::size_t player, const Eigen::Vector2d& target);
  void keep_apart();
  [[nodiscard]] std::size_t hunter(std::size_t from, std::size_t to) const;
  void kick_if_reached(std::size_t player);
  void kick(TrueBall& ball, const Eigen::Vector2d& away);
  void move(TrueBall& ball) const;

  PlayParameters parameters_;
  Eigen::Vector2d half_;
  Eigen::Vector2d wall_;  // half the carpet
  Random random_;
  Moment moment_;
  std::vector<Eigen::Vector2d> targets_;
  std::vector<double> next_target_;  // s
  std::vector<double> may_kick_;     // s
};

}  // namespace teamsight::play
