// fusion/measurement.hpp: from what a robot saw in R to points in F, with honest covariances.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "fusion/planar_filter.hpp"
#include "geometry/sighting.hpp"

namespace teamsight::fusion {

/// A ray in polar form on the floor around the ray's origin.
struct PolarBall {
  double azimuth{0.0};  ///< about z of R; rad
  double range{0.0};    ///< from below the ray's origin, along the floor; m
  Eigen::Matrix2d cov{Eigen::Matrix2d::Identity()};  ///< of (azimuth, range)
};

/// Where a ball that lies on the floor must be, if its centre is on this ray.
///
/// The ray meets the plane at the height of the ball's centre. If the angular radius was measured,
/// it gives the range a second time: both are combined; where they contradict each other (99.7 %),
/// the floor's range stays and its variance grows by the gap squared, for the ball may be flying.
///
/// @return nothing if the ray does not come down to that plane (shallower than 0.5 degrees)
[[nodiscard]] std::optional<PolarBall> ball_on_floor(const BallRay& ray, double ball_radius);

/// d(x, y)/d(azimuth, range) of a floor point in R.
[[nodiscard]] Eigen::Matrix2d polar_jacobian(double azimuth, double range);

/// d(range)/d(elevation) of a ray from `height` above the plane of the ball's centre.
///
/// @param elevation  rad, negative: downwards
[[nodiscard]] double range_slope(double height, double elevation);

/// A ball in space, by its direction and how large it looks.
struct BallInSpace {
  Eigen::Vector3d p_R{Eigen::Vector3d::Zero()};      ///< m
  Eigen::Matrix3d cov{Eigen::Matrix3d::Identity()};  ///< of p_R; m^2
};

/// @return nothing if its angular radius was not measured
[[nodiscard]] std::optional<BallInSpace> ball_by_size(const BallRay& ray, double ball_radius);

/// A ball in space as a place on the floor of F, below it.
///
/// @param posture  of the observer at exposure; its covariance goes into the result
[[nodiscard]] PlanarMeasurement below(const BallInSpace& ball, const PostureEstimate& posture);

/// A ball ray as a floor point in F.
///
/// @param posture  of the observer at exposure; its covariance goes into the result
/// @return nothing where `ball_on_floor` has nothing
[[nodiscard]] std::optional<PlanarMeasurement> measure_ball(const BallRay& ray,
                                                            const PostureEstimate& posture,
                                                            double ball_radius);

/// The centre of a sighted obstacle in F: its radius behind the foot that was seen.
///
/// @param radius  of the obstacle; m
[[nodiscard]] PlanarMeasurement measure_obstacle(const ObstacleSighting& sighting,
                                                 const PostureEstimate& posture,
                                                 double radius);

/// Half the sighted width, or `fallback` where the width was not measured or cannot be a robot's
/// (not within 0.05 ... 0.6 m).
[[nodiscard]] double radius_of(const ObstacleSighting& sighting, double fallback);

}  // namespace teamsight::fusion
