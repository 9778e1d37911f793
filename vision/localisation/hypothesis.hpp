// vision/localisation/hypothesis.hpp: one idea of where the robot is and how it moves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "geometry/frames.hpp"
#include "geometry/pose.hpp"
#include "geometry/time.hpp"
#include "vision/localisation/motion_log.hpp"

namespace teamsight::vision {

/// Of (x, y, theta) in F and (v_x, v_y, omega) in R; m, rad, s.
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A posture with its velocity; the filter's state.
struct Hypothesis {
  std::uint32_t id{0};
  Pose<Field, Robot> X_FR;
  Velocity<Robot> v_R;
  double omega{0.0};  ///< rad/s
  Matrix6 cov{Matrix6::Identity()};
  double log_weight{0.0};     ///< against the other hypotheses
  double half_log_odds{0.0};  ///< that X_FR is right rather than its mirror image; own evidence

  [[nodiscard]] Eigen::Matrix3d cov_pose() const { return cov.topLeftCorner<3, 3>(); }

  /// The larger of the two position sigmas; m.
  [[nodiscard]] double sigma_position() const;
};

/// Turns (x, y, theta) by a rotation of the plane.
[[nodiscard]] Eigen::Matrix3d turned(const Eigen::Matrix2d& R_FR);

/// What a robot can do when no wheels tell.
struct DriveLimits {
  double sigma_acceleration{3.0};       ///< m/s^2 over a tenth of a second
  double sigma_turn_acceleration{8.0};  ///< rad/s^2
  double sigma_velocity{2.0};           ///< of a robot of which nothing is known; m/s
  double sigma_omega{3.0};              ///< rad/s
};

/// Carries a hypothesis on by what the wheels counted.
void carry(Hypothesis& hypothesis, const Walk& walk, const WheelReading& newest);

/// Carries it on at its own velocity, with white acceleration.
void coast(Hypothesis& hypothesis, double seconds, const DriveLimits& limits);

/// How far a measured posture is from the expected one, and how far that is in sigmas.
struct Innovation {
  Eigen::Vector3d gap;  ///< measured minus expected; m, m, rad
  double nis{0.0};      ///< squared Mahalanobis distance; three degrees of freedom
};

/// @param cov  of the measured posture
[[nodiscard]] Innovation innovation_of(const Hypothesis& hypothesis,
                                       const Pose<Field, Robot>& measured,
                                       const Eigen::Matrix3d& cov);

/// Takes a measured posture in (Kalman, Joseph's form).
void correct(Hypothesis& hypothesis,
             const Pose<Field, Robot>& measured,
             const Eigen::Matrix3d& cov);

/// The same place from the other side of the field, velocity and covariance included.
[[nodiscard]] Hypothesis mirrored(const Hypothesis& hypothesis, const Point<Field>& centre);

inline constexpr std::size_t kMaxHypotheses = 5;

/// All ideas at one moment. A value without allocation.
struct Belief {
  HostTime at{};
  std::array<Hypothesis, kMaxHypotheses> places;
  std::size_t count{0};

  [[nodiscard]] std::span<Hypothesis> all() { return {places.data(), count}; }

  [[nodiscard]] std::span<const Hypothesis> all() const { return {places.data(), count}; }

  /// Adds one, in place of the least likely one if there are too many.
  void add(const Hypothesis& hypothesis);

  /// Sorts by weight, the best at 0, merges what has become the same place (or its mirror image on
  /// a symmetric field), drops what is too unlikely.
  void tidy(bool symmetric, const Point<Field>& centre);

  /// Probability of the first one among all; 0 if there is none.
  [[nodiscard]] double share_of_best() const;
};

}  // namespace teamsight::vision
