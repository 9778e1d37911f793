// tests/vision/synthetic_points.hpp: line points as a perfect detector with known noise sees them.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/field_model.hpp"
#include "geometry/pose.hpp"
#include "vision/line_points.hpp"

namespace teamsight::vision {

/// A 12 x 8 m field with centre circle, centre line and penalty areas; symmetric under half a turn.
inline FieldModel test_field() {
  FieldModel field;
  field.name = "test";
  field.length = 12.0;
  field.width = 8.0;
  field.surround = 1.0;
  field.line_width = 0.125;
  const auto line = [&](double x1, double y1, double x2, double y2) {
    field.lines.push_back({"line", {x1, y1}, {x2, y2}, LineFamily::kOther});
  };
  line(-6, -4, 6, -4);
  line(-6, 4, 6, 4);
  line(-6, -4, -6, 4);
  line(6, -4, 6, 4);
  line(0, -4, 0, 4);
  for (const double side : {-1.0, 1.0}) {
    line(side * 6, -2, side * 4.5, -2);
    line(side * 6, 2, side * 4.5, 2);
    line(side * 4.5, -2, side * 4.5, 2);
  }
  field.arcs.push_back({"circle", {0, 0}, 1.5, 0.0, 2.0 * std::numbers::pi});
  return field;
}

/// Points of every line within `range` of the robot, 0.2 m apart, with isotropic noise.
inline std::vector<LinePoint> line_points_from(const FieldModel& field,
                                               const Pose<Field, Robot>& X_FR,
                                               double sigma,
                                               double outliers,
                                               std::mt19937& random) {
  constexpr double kRange = 6.0;
  constexpr double kSpacing = 0.2;
  std::vector<Eigen::Vector2d> paint;
  for (const FieldLine& line : field.lines) {
    const Eigen::Vector2d along = line.to.vector() - line.from.vector();
    const auto pieces = static_cast<int>(along.norm() / kSpacing);
    for (int i = 0; i < pieces; ++i) {
      const double s = kSpacing * (i + 0.5);
      paint.emplace_back(line.from.vector() + s * along.normalized());
    }
  }
  for (const FieldArc& arc : field.arcs) {
    const auto pieces = static_cast<int>(arc.sweep * arc.radius / kSpacing);
    for (int i = 0; i < pieces; ++i) {
      const double a = arc.start + kSpacing / arc.radius * i;
      paint.emplace_back(arc.centre.vector() +
                         arc.radius * Eigen::Vector2d(std::cos(a), std::sin(a)));
    }
  }
  std::normal_distribution<double> noise(0.0, sigma);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::uniform_real_distribution<double> anywhere(-kRange, kRange);
  std::vector<LinePoint> points;
  for (const Eigen::Vector2d& p : paint) {
    const Point<Robot> p_R = X_FR.inverse() * Point<Field>::from(p);
    if (p_R.vector().norm() > kRange) continue;
    LinePoint point;
    point.p_R = {p_R.x + noise(random), p_R.y + noise(random)};
    if (share(random) < outliers) point.p_R = {anywhere(random), anywhere(random)};
    point.cov_R = sigma * sigma * Eigen::Matrix2d::Identity();
    points.push_back(point);
  }
  return points;
}

/// Anywhere on the lined part of the field.
inline Pose<Field, Robot> random_pose(const FieldModel& field, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-0.45, 0.45);
  std::uniform_real_distribution<double> turn(-std::numbers::pi, std::numbers::pi);
  return {field.centre.x + unit(random) * field.length,
          field.centre.y + unit(random) * field.width,
          turn(random)};
}

}  // namespace teamsight::vision
