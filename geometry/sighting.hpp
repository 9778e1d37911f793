// geometry/sighting.hpp: what one robot's camera says about one moment: posture, balls, obstacles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/frames.hpp"
#include "geometry/pose.hpp"

namespace teamsight {

/// How far a posture may be believed.
enum class PostureStatus : std::uint8_t {
  kLost,       ///< the lines do not support any posture; pose and covariance say nothing
  kAmbiguous,  ///< right up to the field's symmetry, or one of several candidates
  kOk,
};

/// A robot's posture with its covariance, at the exposure of a frame.
struct PostureEstimate {
  PostureStatus status{PostureStatus::kLost};
  Pose<Field, Robot> X_FR;
  Eigen::Matrix3d cov{Eigen::Matrix3d::Identity()};  ///< of (x, y, theta); m, m, rad
  /// Log-odds that X_FR is right rather than its mirror image, from the robot's own evidence
  /// alone; 0 = undecided. What the team told it is never in here.
  double half_log_odds{0.0};
  double inlier_ratio{0.0};      ///< of the line points, in [0, 1]
  std::uint16_t line_points{0};  ///< how many there were

  friend bool operator==(const PostureEstimate&, const PostureEstimate&) = default;
};

enum class BallColour : std::uint8_t { kUnknown, kOrange, kRed, kYellow, kPatterned };

/// One ball candidate: the ray through its centre. Where along the ray is fusion's business.
struct BallRay {
  Ray<Robot> ray_R;            ///< origin on the mirror, through the ball's centre
  double angular_radius{0.0};  ///< half the angle the ball fills; rad; 0 = not measured
  /// Covariance of the direction: (azimuth about z, elevation), rad^2.
  Eigen::Matrix2d cov_direction{Eigen::Matrix2d::Identity()};
  double sigma_angular_radius{0.0};  ///< rad; 0 = angular_radius not measured
  double confidence{0.0};            ///< probability that it is a ball at all, in [0, 1]
  BallColour colour{BallColour::kUnknown};

  friend bool operator==(const BallRay&, const BallRay&) = default;
};

/// Something that stands on the floor and is neither ball nor goal.
struct ObstacleSighting {
  Point<Robot> p_RO;                                   ///< its foot nearest to the observer; m
  Eigen::Matrix2d cov_R{Eigen::Matrix2d::Identity()};  ///< of p_RO in R; m^2
  double width{0.0};                                   ///< across the line of sight; m
  double confidence{0.0};           ///< probability that it is an obstacle at all, in [0, 1]
  double teammate_likelihood{0.5};  ///< from markers and shirts, in [0, 1]; 0.5 = no evidence

  friend bool operator==(const ObstacleSighting&, const ObstacleSighting&) = default;
};

inline constexpr std::size_t kMaxBallRays = 4;
inline constexpr std::size_t kMaxObstacleSightings = 16;

}  // namespace teamsight
