// bench/play/perception.hpp: what a robot would report of a true moment, wrong as cameras are.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bench/play/play.hpp"
#include "fusion/observation.hpp"

namespace teamsight::play {

/// How a robot errs. None of it reaches fusion, but for the covariances that a robot claims.
struct PerceptionParameters {
  double rate{25.0};                    ///< frames per second
  double sigma_posture_position{0.03};  ///< m per coordinate, correlated over `posture_memory`
  double sigma_posture_heading{0.008};  ///< rad
  double posture_memory{1.0};           ///< s
  double sigma_scale{0.015};            ///< of distances: calibration, drawn once per robot
  double sigma_azimuth_offset{0.005};   ///< rad, likewise
  double sigma_direction{0.003};        ///< rad per frame, heavy-tailed (Student, 4 degrees)
  double sigma_direction_slow{0.002};   ///< rad, correlated over `direction_memory`
  double direction_memory{0.3};         ///< s
  double share_radius{0.10};            ///< of the ball's apparent radius
  double ball_range{8.0};               ///< m; nothing is seen beyond
  double obstacle_range{6.0};           ///< m
  double false_balls{0.01};             ///< per frame, in that frame only
  double false_obstacles{0.01};         ///< per frame, in that frame only
  double phantoms{0.5};                 ///< a minute and kind, in the same place for a second
};

/// What is wrong with a robot, beyond the ordinary.
enum class Fault : std::uint8_t { kNone, kBiased, kMirrored, kKidnapped };

/// The robot's errors that last: to be known by nobody but the bound.
struct SlowErrors {
  Eigen::Vector3d posture{Eigen::Vector3d::Zero()};  ///< of (x, y, theta) in F
  double scale{0.0};
  double azimuth_offset{0.0};
  Eigen::Vector2d direction{Eigen::Vector2d::Zero()};  ///< azimuth, elevation
};

inline constexpr double kMirrorHeight = 0.8;  // m

/// One robot's eyes.
class Perception {
 public:
  Perception(const PerceptionParameters& parameters, RobotId robot, std::uint64_t seed);

  /// What it reports of this moment; `exposure` is left to the caller.
  ///
  /// @param since  s since its last frame
  [[nodiscard]] fusion::Observation look(const Moment& moment,
                                         double since,
                                         const PlayParameters& play);

  /// From now on this is wrong with it.
  void set_fault(Fault fault, const Moment& moment);

  /// Which of the moment's balls the last frame shows, a bit each.
  [[nodiscard]] std::uint32_t seen_balls() const { return seen_balls_; }

  /// Which of the moment's players the last frame shows, a bit each.
  [[nodiscard]] std::uint64_t seen_players() const { return seen_players_; }

 private:
  /// Something that is not there, in R.
  struct Phantom {
    Eigen::Vector2d p_R{Eigen::Vector2d::Zero()};
    double left{0.0};  // s
    bool is_ball{false};
  };

  void age(double since);
  [[nodiscard]] double heavy(double sigma);
  [[nodiscard]] PostureEstimate claimed_posture(const TruePlayer& self) const;
  void see_ball(const Eigen::Vector3d& p_RB, double radius, fusion::Observation& frame);
  void see_obstacle(const Eigen::Vector2d& p_RO, double radius, fusion::Observation& frame);
  void see_balls(const Moment& moment,
                 const TruePlayer& self,
                 const PlayParameters& play,
                 fusion::Observation& frame);
  void see_players(const Moment& moment,
                   const TruePlayer& self,
                   const PlayParameters& play,
                   fusion::Observation& frame);
  void see_phantoms(double since, const PlayParameters& play, fusion::Observation& frame);

  PerceptionParameters parameters_;
  RobotId robot_;
  Random random_;
  SlowErrors slow_;
  double claim_{1.0};  // claimed standard deviations over true ones
  std::uint32_t sequence_{0};
  std::uint32_t seen_balls_{0};
  std::uint64_t seen_players_{0};
  std::vector<Phantom> phantoms_;
  Fault fault_{Fault::kNone};
  Eigen::Vector3d fault_offset_{Eigen::Vector3d::Zero()};
};

}  // namespace teamsight::play
