// geometry/world_model.hpp: the team's shared picture of one moment, as every robot reads it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/frames.hpp"
#include "geometry/identity.hpp"
#include "geometry/pose.hpp"
#include "geometry/sighting.hpp"
#include "geometry/time.hpp"

namespace teamsight {

/// The ball, or one of several.
struct WorldBall {
  std::uint32_t track{
      0};                 ///< stable while the track lives, also when another fusion takes the lead
  Point3<Field> p_FB;     ///< ball centre; m
  Velocity3<Field> v_FB;  ///< m/s
  Eigen::Matrix3d cov_p{Eigen::Matrix3d::Identity()};  ///< of p_FB; m^2
  Eigen::Matrix3d cov_v{Eigen::Matrix3d::Identity()};  ///< of v_FB; (m/s)^2
  double existence{0.0};    ///< probability that there is such a ball, in [0, 1]
  Duration age{0};          ///< since the exposure of the last observation in it
  RobotMask supporters{0};  ///< whose observations are in it
  RobotMask rejected{0};    ///< who sees a ball that does not fit this one

  friend bool operator==(const WorldBall&, const WorldBall&) = default;
};

/// Why a robot's observations are not used.
enum class Quarantine : std::uint8_t {
  kNone,
  kNoPosture,    ///< it does not know where it is
  kBiased,       ///< what it sees lies aside from what the others see
  kMirrored,     ///< it stands on the other half
  kKidnapped,    ///< its posture jumped
  kBabbling,     ///< too many or contradictory samples
  kDuplicateId,  ///< two processes speak under its id
};

/// A robot of the own team.
struct WorldTeammate {
  RobotId robot{kNobody};
  PostureStatus status{PostureStatus::kLost};
  Pose<Field, Robot> X_FR;
  Velocity<Field> v_FR;                              ///< m/s
  Eigen::Matrix3d cov{Eigen::Matrix3d::Identity()};  ///< of (x, y, theta); m, m, rad
  double half_log_odds{0.0};                         ///< the robot's own, see PostureEstimate
  /// Log-odds that X_FR is right rather than its mirror image, from comparing what this robot sees
  /// with what the others do; 0 = undecided. The robot's own log-odds are not in it. For the
  /// posture that frame `frame` carried.
  double half_log_odds_team{0.0};
  std::uint32_t frame{0};  ///< sequence of its newest frame in here
  Duration age{0};         ///< since its last frame's exposure
  double trust{0.0};       ///< in [0, 1]
  Quarantine quarantine{Quarantine::kNone};
  bool sees_ball{false};

  friend bool operator==(const WorldTeammate&, const WorldTeammate&) = default;
};

/// Anything else that stands on the field: opponents, referees, people.
struct WorldObstacle {
  std::uint32_t track{0};                              ///< stable while the track lives
  Point<Field> p_FO;                                   ///< centre; m
  Velocity<Field> v_FO;                                ///< m/s
  Eigen::Matrix2d cov_p{Eigen::Matrix2d::Identity()};  ///< m^2
  double radius{0.0};                                  ///< m
  double existence{0.0};                               ///< in [0, 1]
  Duration age{0};  ///< since the exposure of the last observation in it
  RobotMask supporters{0};

  friend bool operator==(const WorldObstacle&, const WorldObstacle&) = default;
};

inline constexpr std::size_t kMaxWorldBalls = 2;
inline constexpr std::size_t kMaxWorldTeammates = 6;
inline constexpr std::size_t kMaxWorldObstacles = 12;

/// The team's shared picture of one moment.
///
/// Empty lists mean "nobody knows", never "there is none".
struct WorldModel {
  ObservationId id;              ///< the fusion that made it (robot, boot) and its count
  std::uint16_t strength{0};     ///< of that fusion; the strongest alive leads
  PeerTime stamp;                ///< the moment all positions are predicted to; maker's clock
  std::vector<WorldBall> balls;  ///< most probable first; at most kMaxWorldBalls
  std::vector<WorldTeammate> teammates;  ///< by robot id; at most kMaxWorldTeammates
  std::vector<WorldObstacle> obstacles;  ///< by track id; at most kMaxWorldObstacles

  friend bool operator==(const WorldModel&, const WorldModel&) = default;
};

}  // namespace teamsight
