// bench/locate_rivals/rprop.cpp: error, gradient, steps by its sign.
#include "bench/locate_rivals/rprop.hpp"

#include <cmath>
#include <limits>

namespace teamsight::locate_rivals {

namespace {

struct Slope {
  double error{0.0};
  Eigen::Vector3d gradient{Eigen::Vector3d::Zero()};
};

Slope slope_at(const DistanceTable& table,
               std::span<const vision::LinePoint> points,
               const Eigen::Vector3d& at,
               const RpropParameters& parameters) {
  const Pose<Field, Robot> X_FR(at.x(), at.y(), at.z());
  const Eigen::Matrix2d R_FR = X_FR.rotation();
  const double c2 = parameters.width * parameters.width;
  Slope slope;
  for (const vision::LinePoint& point : points) {
    const Eigen::Vector2d p = R_FR * point.p_R.vector();
    const Eigen::Vector2d p_F = at.head<2>() + p;
    const double d = table.distance(p_F);
    const double weight = (1.5 + parameters.far2) / (parameters.far2 + p.squaredNorm());
    slope.error += weight * (1.0 - c2 / (c2 + d * d));
    const double steepness = weight * 2.0 * c2 * d / ((c2 + d * d) * (c2 + d * d));
    const Eigen::Vector2d gradient = steepness * table.gradient(p_F);
    slope.gradient.head<2>() += gradient;
    slope.gradient.z() += gradient.dot(Eigen::Vector2d(-p.y(), p.x()));
  }
  return slope;
}

}  // namespace

Pose<Field, Robot> rprop(const DistanceTable& table,
                         std::span<const vision::LinePoint> points,
                         const Pose<Field, Robot>& start,
                         const RpropParameters& parameters) {
  Eigen::Vector3d at = start.vector();
  Eigen::Vector3d step(parameters.first_place, parameters.first_place, parameters.first_turn);
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  Eigen::Vector3d best = at;
  double least = std::numeric_limits<double>::infinity();
  const int steps = points.size() > 20 ? parameters.steps : parameters.steps_few;
  for (int i = 0; i <= steps; ++i) {
    const Slope slope = slope_at(table, points, at, parameters);
    if (slope.error < least) {
      least = slope.error;
      best = at;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double agreement = slope.gradient(axis) * last(axis);
      if (agreement > 0.0) step(axis) *= parameters.grow;
      if (agreement < 0.0) step(axis) *= parameters.shrink;
      if (slope.gradient(axis) != 0.0) at(axis) -= std::copysign(step(axis), slope.gradient(axis));
    }
    last = slope.gradient;
  }
  return {best.x(), best.y(), best.z()};
}

}  // namespace teamsight::locate_rivals
