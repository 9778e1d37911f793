// fusion/planar_filter.hpp: position and velocity on the floor, as a Kalman filter in information
// form.
#pragma once

#include <Eigen/Core>

namespace teamsight::fusion {

/// A floor point in F with its covariance, as one frame of one robot says.
struct PlanarMeasurement {
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};        ///< m
  Eigen::Matrix2d cov_F{Eigen::Matrix2d::Identity()};  ///< m^2
};

/// Position and velocity in F with their covariance: (x, y, vx, vy); m, m/s.
struct PlanarMoments {
  Eigen::Vector4d mean{Eigen::Vector4d::Zero()};
  Eigen::Matrix4d cov{Eigen::Matrix4d::Identity()};
};

/// Motion between observations: velocity fades exponentially, disturbed by white acceleration.
struct PlanarMotion {
  double acceleration_psd{1.0};  ///< m^2/s^3
  double velocity_decay{0.0};    ///< 1/s
};

/// One step forward: state' = transition * state, and what the disturbance adds to the covariance.
struct PlanarStep {
  Eigen::Matrix4d transition;
  Eigen::Matrix4d disturbance;
};

/// @param dt  s, above 0
[[nodiscard]] PlanarStep planar_step(double dt, const PlanarMotion& motion);

/// State of the filter: information matrix and information vector, in which independent
/// observations of one instant simply add up.
class PlanarFilter {
 public:
  PlanarFilter() = default;

  /// @pre the covariance is positive definite
  [[nodiscard]] static PlanarFilter from(const PlanarMoments& moments);

  [[nodiscard]] PlanarMoments moments() const;

  /// Goes forward in time.
  ///
  /// @param dt  s, at least 0; nothing happens at 0
  void predict(double dt, const PlanarMotion& motion);

  /// Adds what one observation says. @pre its covariance is positive definite
  void update(const PlanarMeasurement& measurement);

 private:
  Eigen::Matrix4d info_{Eigen::Matrix4d::Identity()};
  Eigen::Vector4d info_mean_{Eigen::Vector4d::Zero()};  // information matrix times mean
};

/// Where `moments` will be, `dt` seconds later.
[[nodiscard]] PlanarMoments predicted(const PlanarMoments& moments,
                                      double dt,
                                      const PlanarMotion& motion);

/// How far a measurement lies from a track.
struct PlanarInnovation {
  double squared_distance{0.0};  ///< Mahalanobis; chi-square with 2 degrees of freedom if right
  double log_determinant{0.0};   ///< of the innovation's covariance
};

[[nodiscard]] PlanarInnovation innovation(const PlanarMoments& moments,
                                          const PlanarMeasurement& measurement);

}  // namespace teamsight::fusion
