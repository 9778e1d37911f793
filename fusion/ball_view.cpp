// fusion/ball_view.cpp: see fusion/ball_view.hpp.
#include "fusion/ball_view.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace teamsight::fusion {
namespace {

constexpr double kNearest = 0.02;  // m; straight below the mirror there is no azimuth

struct RayGeometry {
  Eigen::Vector2d way_R{Eigen::Vector2d::Zero()};  // along the floor, from below the ray's origin
  double range{0.0};                               // its length
  double drop{0.0};                                // of the ball below the ray's origin
  double c{1.0};
  double s{0.0};
};

RayGeometry geometry_of(const Eigen::Vector3d& p_F,
                        const Eigen::Vector3d& posture,
                        const Point3<Robot>& origin) {
  RayGeometry ray;
  ray.c = std::cos(posture.z());
  ray.s = std::sin(posture.z());
  const Eigen::Vector2d way_F = p_F.head<2>() - posture.head<2>();
  ray.way_R << ray.c * way_F.x() + ray.s * way_F.y() - origin.x,
      -ray.s * way_F.x() + ray.c * way_F.y() - origin.y;
  ray.range = std::max(kNearest, ray.way_R.norm());
  ray.drop = origin.z - p_F.z();
  return ray;
}

double angular_radius(const RayGeometry& ray, double ball_radius) {
  return std::asin(std::min(0.99, ball_radius / std::hypot(ray.range, ray.drop)));
}

/// d(azimuth, elevation, angular radius)/d(place in R).
Eigen::Matrix3d slope_by_place(const RayGeometry& seen, double angular) {
  const double distance_squared = seen.range * seen.range + seen.drop * seen.drop;
  const Eigen::Vector2d along = seen.way_R / seen.range;
  Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
  slope.row(0).head<2>() << -along.y() / seen.range, along.x() / seen.range;
  slope.row(1) << along.x() * seen.drop / distance_squared,
      along.y() * seen.drop / distance_squared, seen.range / distance_squared;
  const double by_distance = -std::tan(angular) / distance_squared;
  slope.row(2) << by_distance * seen.way_R.x(), by_distance * seen.way_R.y(),
      -by_distance * seen.drop;
  return slope;
}

/// What was measured minus what was expected, and its covariance.
void fill_gap(const BallRay& ray, const Eigen::Vector3d& expected, ConsideredView<6, 3>& view) {
  const Eigen::Vector3d& direction = ray.ray_R.direction;
  view.gap << angle_difference(std::atan2(direction.y(), direction.x()), expected(0)),
      std::atan2(direction.z(), direction.head<2>().norm()) - expected(1), 0.0;
  view.cov.setZero();
  view.cov.topLeftCorner<2, 2>() = ray.cov_direction;
  view.cov(2, 2) = kSizeNotMeasured;
  if (ray.angular_radius <= 0.0 || ray.sigma_angular_radius <= 0.0) return;
  view.gap(2) = ray.angular_radius - expected(2);
  view.cov(2, 2) = ray.sigma_angular_radius * ray.sigma_angular_radius;
}

}  // namespace

Eigen::Vector3d ray_to(const Eigen::Vector3d& p_F,
                       const Eigen::Vector3d& posture,
                       double scale,
                       const Point3<Robot>& origin,
                       double ball_radius) {
  const RayGeometry ray = geometry_of(p_F, posture, origin);
  return {std::atan2(ray.way_R.y(), ray.way_R.x()),
          -std::atan2(ray.drop, ray.range * (1.0 + scale)),
          angular_radius(ray, ball_radius)};
}

ConsideredView<6, 3> view_of_ball(const BallVector& ball,
                                  const BallRay& ray,
                                  const BallObserver& observer) {
  const Eigen::Vector3d at = observer.posture.X_FR.vector() - observer.errors.head<3>();
  const Eigen::Vector3d p_F = ball.head<3>();
  const Point3<Robot>& origin = ray.ray_R.origin;
  const RayGeometry seen = geometry_of(p_F, at, origin);
  const Eigen::Vector3d expected =
      ray_to(p_F, at, observer.errors(3), origin, observer.ball_radius);

  ConsideredView<6, 3> view;
  view.observer = observer.place;
  fill_gap(ray, expected, view);
  const Eigen::Matrix3d by_place = slope_by_place(seen, expected(2));
  Eigen::Matrix3d to_R = Eigen::Matrix3d::Identity();  // turns F into R
  to_R.topLeftCorner<2, 2>() << seen.c, seen.s, -seen.s, seen.c;
  view.slope.setZero();
  view.slope.leftCols<3>() = by_place * to_R;
  // The posture as reported is ahead of the truth by its errors: minus the derivative by it.
  const Eigen::Vector2d body_R(seen.way_R.x() + origin.x, seen.way_R.y() + origin.y);
  const double distance_squared = seen.range * seen.range + seen.drop * seen.drop;
  view.slope_errors.leftCols<2>() = view.slope.leftCols<2>();
  view.slope_errors.col(2) = by_place.leftCols<2>() * Eigen::Vector2d(-body_R.y(), body_R.x());
  view.slope_errors.col(3) << 0.0, seen.drop * seen.range / distance_squared, 0.0;
  const auto by_posture = view.slope_errors.leftCols<3>();
  view.cov += by_posture * observer.cov_fresh * by_posture.transpose();
  const Eigen::Vector3d moved = view.slope.leftCols<3>() * ball.tail<3>() * observer.sigma_exposure;
  view.cov += moved * moved.transpose();
  return view;
}

}  // namespace teamsight::fusion
