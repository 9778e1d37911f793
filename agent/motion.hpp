// agent/motion.hpp: where the robot may be by the time of the next frame.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "bus/messages.hpp"
#include "geometry/pose.hpp"
#include "geometry/sighting.hpp"
#include "geometry/time.hpp"
#include "vision/posture.hpp"

namespace teamsight::agent {

/// How fast a robot may leave the place where it was seen, and how long that place still says
/// something.
struct MotionParameters {
  double sigma_v{2.0};          ///< of the velocity while no odometry arrives; m/s
  double sigma_omega{3.0};      ///< rad/s
  double sigma_slip{0.1};       ///< of the velocity with odometry; m/s
  double sigma_turn_slip{0.1};  ///< rad/s
  double sigma_useless{3.0};    ///< a prior wider than this is no prior; m
  Duration odometry_stale{std::chrono::milliseconds(100)};
};

/// The wheels' count at one moment.
struct DriveStep {
  HostTime stamp{};
  Pose<Drive, Robot> X_DR;
};

/// Carries the last posture on to the next exposure, with odometry if there is some.
///
/// A value without clock or I/O; every stamp is in this computer's host time.
class Motion {
 public:
  Motion(const MotionParameters& parameters, vision::StartSide start_side);

  /// What a frame said. A posture that is lost changes nothing.
  void see(const PostureEstimate& posture, HostTime exposure);

  /// What somebody said: put there by hand, or by the coach.
  ///
  /// @param cov  of (x, y, theta); m, m, rad
  void place(const Pose<Field, Robot>& X_FR, const Eigen::Matrix3d& cov, HostTime when);

  /// What the wheels said. Older than what is known already: dropped.
  void roll(const bus::Odometry& odometry);

  /// The prior for a frame of that exposure; without X_FR if nothing useful is known.
  [[nodiscard]] vision::MotionPrior prior_at(HostTime exposure) const;

  /// Velocity over the floor and turning rate (rad/s): the wheels', or else from the last two
  /// postures; zero if neither is known.
  [[nodiscard]] Velocity<Robot> velocity(HostTime when) const;
  [[nodiscard]] double omega(HostTime when) const;

 private:
  struct Known {
    HostTime at{};
    Pose<Field, Robot> X_FR;
    Eigen::Matrix3d cov{Eigen::Matrix3d::Identity()};
    double half_log_odds{0.0};
  };

  [[nodiscard]] std::optional<Pose<Drive, Robot>> drive_at(HostTime when) const;
  [[nodiscard]] bool has_fresh_odometry(HostTime when) const;

  MotionParameters parameters_;
  vision::StartSide start_side_;
  std::optional<Known> known_;
  std::array<DriveStep, 128> drive_{};  // a ring; 1.28 s at 100 Hz
  std::size_t drive_count_{0};
  bus::Odometry newest_;
  Velocity<Robot> v_R_seen_;
  double omega_seen_{0.0};
};

}  // namespace teamsight::agent
