// fusion/teammate.hpp: what is known of one robot of the own team from its own postures.
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "fusion/eyesight.hpp"
#include "fusion/parameters.hpp"
#include "fusion/track_book.hpp"
#include "geometry/identity.hpp"
#include "geometry/sighting.hpp"
#include "geometry/time.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::fusion {

/// Velocity from successive postures: a Kalman filter over (x, y, theta, vx, vy, omega) in F.
///
/// The robot's own posture filter has already smoothed the postures, so their errors are not
/// independent: the published posture is the last one carried forward, never a mean of several. The
/// velocity is disturbed by what is new in each posture's error, and by what the rest changes.
struct PostureTrack {
  Eigen::Matrix<double, 6, 1> mean{Eigen::Matrix<double, 6, 1>::Zero()};
  Eigen::Matrix<double, 6, 6> cov{Eigen::Matrix<double, 6, 6>::Identity()};
  PostureEstimate last;   ///< the last posture that was not lost
  HostTime time{kNever};  ///< its exposure; kNever: there was none
};

/// How a posture follows from the one before.
enum class PostureStep : std::uint8_t {
  kSteady,
  kSmallJump,   ///< it corrected itself
  kTurnedOver,  ///< to the mirror image
  kJump,        ///< elsewhere
  kNewProcess,
};

/// A posture as a robot says it.
struct PostureReport {
  const PostureEstimate& posture;
  Eigen::Matrix3d cov_shake;  ///< of its error, what is new since the last; see TeamErrors::shake
  HostTime exposure;
};

/// Takes the next posture in. @pre it is not lost, and not older than the last
///
/// @param far  m: a jump beyond is no correction
PostureStep take_posture(PostureTrack& track,
                         const PostureReport& report,
                         const TeammateParameters& parameters,
                         double far = 0.5);

/// A robot's posture carried forward.
struct CarriedPosture {
  Pose<Field, Robot> X_FR;
  Velocity<Field> v_FR;                              ///< m/s
  Eigen::Matrix3d cov{Eigen::Matrix3d::Identity()};  ///< of (x, y, theta); m, m, rad
  /// What the way since the last posture adds, if that posture's error is known otherwise.
  Eigen::Matrix3d cov_since{Eigen::Matrix3d::Zero()};
};

/// @pre the track has a posture
/// @param now  not before the last posture; if it is, the last posture itself
[[nodiscard]] CarriedPosture carried_to(const PostureTrack& track,
                                        HostTime now,
                                        const TeammateParameters& parameters);

/// One robot's processes, its postures, and the books about its observations.
struct Teammate {
  RobotId robot{kNobody};
  PostureStatus status{PostureStatus::kLost};  ///< of its last frame
  std::uint32_t boot{0};                       ///< of the process that speaks for it
  std::uint32_t other_boot{0};                 ///< the one that spoke before; 0 = none
  std::uint32_t frame{0};                      ///< sequence of its last frame
  HostTime other_seen{kNever};                 ///< when that one spoke last
  HostTime duplicate_seen{kNever};             ///< when two were last heard in turn
  HostTime seen{kNever};                       ///< exposure of its last frame
  HostTime ball_seen{kNever};
  double half_log_odds{0.0};  ///< of its last frame
  Eyesight eyes;
  PostureTrack posture;
  std::uint32_t accepted{0};          ///< ball rays and obstacle sightings used
  std::uint32_t rejected_gate{0};     ///< ... that fitted nothing
  std::uint32_t rejected_posture{0};  ///< frames unused for want of a posture
};

/// Notes that this frame of this robot came, with this posture.
PostureStep take_frame(Teammate& teammate,
                       const ObservationId& id,
                       const PostureReport& report,
                       const Parameters& parameters);

/// Whether this posture can carry sightings into F: it is sure, or ambiguous with the robot's own
/// evidence for this half.
[[nodiscard]] bool is_resolved(PostureStatus status,
                               double half_log_odds,
                               const TeammateParameters& parameters);

/// Why this robot's observations are not used at `now`.
[[nodiscard]] Quarantine quarantine_of(const Teammate& teammate,
                                       HostTime now,
                                       const TeammateParameters& parameters);

}  // namespace teamsight::fusion
