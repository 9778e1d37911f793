// geometry/pose.hpp: where one frame stands in another, on the floor.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "geometry/angle.hpp"
#include "geometry/frames.hpp"

namespace teamsight {

/// The pose of frame `B` in frame `A`, both standing on the floor: `X_AB`.
///
/// `Pose<Field, Robot> X_FR; Point<Robot> p_RB;  Point<Field> p_FB = X_FR * p_RB;`
/// Letters that do not meet do not compile.
template <class A, class B>
class Pose {
 public:
  Pose() = default;

  /// @param x, y   origin of B in A; metres
  /// @param theta  direction of B's x axis in A, from A's x axis; radians, any
  Pose(double x, double y, double theta) : x_(x), y_(y), theta_(wrap_angle(theta)) {}

  [[nodiscard]] double x() const { return x_; }

  [[nodiscard]] double y() const { return y_; }

  /// In (-pi, pi].
  [[nodiscard]] double theta() const { return theta_; }

  [[nodiscard]] Point<A> origin() const { return {x_, y_}; }

  /// (x, y, theta), for the inside of a function.
  [[nodiscard]] Eigen::Vector3d vector() const { return {x_, y_, theta_}; }

  /// Turns vectors from B into A.
  [[nodiscard]] Eigen::Matrix2d rotation() const {
    const double c = std::cos(theta_);
    const double s = std::sin(theta_);
    return (Eigen::Matrix2d() << c, -s, s, c).finished();
  }

  [[nodiscard]] Pose<B, A> inverse() const {
    const Eigen::Vector2d back = -(rotation().transpose() * Eigen::Vector2d(x_, y_));
    return {back.x(), back.y(), -theta_};
  }

  friend bool operator==(const Pose&, const Pose&) = default;

 private:
  double x_{0.0};
  double y_{0.0};
  double theta_{0.0};
};

template <class A, class B>
[[nodiscard]] Point<A> operator*(const Pose<A, B>& X_AB, const Point<B>& p_B) {
  return Point<A>::from(X_AB.origin().vector() + X_AB.rotation() * p_B.vector());
}

template <class A, class B>
[[nodiscard]] Point3<A> operator*(const Pose<A, B>& X_AB, const Point3<B>& p_B) {
  const Point<A> floor = X_AB * p_B.on_floor();
  return {floor.x, floor.y, p_B.z};
}

/// Turns only: both velocities are relative to the ground.
template <class A, class B>
[[nodiscard]] Velocity<A> operator*(const Pose<A, B>& X_AB, const Velocity<B>& v_B) {
  return Velocity<A>::from(X_AB.rotation() * v_B.vector());
}

template <class A, class B>
[[nodiscard]] Ray<A> operator*(const Pose<A, B>& X_AB, const Ray<B>& ray_B) {
  Ray<A> ray_A;
  ray_A.origin = X_AB * ray_B.origin;
  ray_A.direction.template head<2>() = X_AB.rotation() * ray_B.direction.template head<2>();
  ray_A.direction.z() = ray_B.direction.z();
  return ray_A;
}

template <class A, class B, class C>
[[nodiscard]] Pose<A, C> operator*(const Pose<A, B>& X_AB, const Pose<B, C>& X_BC) {
  const Point<A> origin = X_AB * X_BC.origin();
  return {origin.x, origin.y, X_AB.theta() + X_BC.theta()};
}

/// The field looks the same from `X_FR` and from here: half a turn about `centre`.
///
/// @param centre the field's centre of symmetry in F; the origin unless a field file says otherwise
[[nodiscard]] Pose<Field, Robot> mirrored(const Pose<Field, Robot>& X_FR,
                                          const Point<Field>& centre = {});

/// How the covariance of a floor point in R looks in F when the pose is uncertain too.
///
/// First order: R cov_R R' + J cov_X J', J = d(X_FR p_R)/d(x, y, theta).
///
/// @param cov_X  covariance of (x, y, theta) of X_FR; m, m, rad
/// @param cov_R  covariance of p_R in R; m^2
[[nodiscard]] Eigen::Matrix2d transform_covariance(const Pose<Field, Robot>& X_FR,
                                                   const Eigen::Matrix3d& cov_X,
                                                   const Point<Robot>& p_R,
                                                   const Eigen::Matrix2d& cov_R);

}  // namespace teamsight
