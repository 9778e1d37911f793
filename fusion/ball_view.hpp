// fusion/ball_view.hpp: what a robot's ray says of a ball in space.
#pragma once

#include <Eigen/Core>

#include "fusion/ball_motion.hpp"
#include "fusion/considered.hpp"
#include "geometry/sighting.hpp"

namespace teamsight::fusion {

/// Who looks at a ball, and how sure that is.
struct BallObserver {
  PostureEstimate posture;                  ///< as it says
  ErrorPlace place{kNoPlace};               ///< of what is remembered of its errors
  ErrorVector errors{ErrorVector::Zero()};  ///< estimated; the posture is corrected by them
  /// Of (x, y, theta): by what the posture errs beside, anew in each frame.
  Eigen::Matrix3d cov_fresh{Eigen::Matrix3d::Zero()};
  double sigma_exposure{0.0};  ///< s; times the ball's speed it moves the ball
  double ball_radius{0.11};    ///< m
};

/// Variance of an angular radius that was not measured; rad^2.
inline constexpr double kSizeNotMeasured = 1e4;

/// The ray as an observation of (azimuth, elevation, angular radius) of a ball, linear around
/// `ball`. An angular radius that was not measured has a covariance that says so.
[[nodiscard]] ConsideredView<6, 3> view_of_ball(const BallVector& ball,
                                                const BallRay& ray,
                                                const BallObserver& observer);

/// (azimuth, elevation, angular radius) of a ball at `p_F`, seen from `origin` in R.
///
/// @param scale  share by which distances are seen too long
[[nodiscard]] Eigen::Vector3d ray_to(const Eigen::Vector3d& p_F,
                                     const Eigen::Vector3d& posture,
                                     double scale,
                                     const Point3<Robot>& origin,
                                     double ball_radius);

}  // namespace teamsight::fusion
