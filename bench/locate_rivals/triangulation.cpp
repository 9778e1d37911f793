// bench/locate_rivals/triangulation.cpp: edges, bearings, the filter.
#include "bench/locate_rivals/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/angle.hpp"

namespace teamsight::locate_rivals {

namespace {

constexpr double kSameEdge = 0.05;  // m
constexpr double kGate = 9.0;       // three sigma

void add(std::vector<Point<Field>>& edges, const Point<Field>& edge) {
  const bool is_known = std::ranges::any_of(edges, [&](const auto& known) {
    return (known.vector() - edge.vector()).norm() < kSameEdge;
  });
  if (!is_known) edges.push_back(edge);
}

}  // namespace

std::vector<Point<Field>> upright_edges(const FieldModel& field) {
  std::vector<Point<Field>> edges;
  for (const Goal& goal : field.goals) {
    add(edges, goal.left_post);
    add(edges, goal.right_post);
  }
  for (const Wall& wall : field.walls) {
    add(edges, wall.from);
    add(edges, wall.to);
  }
  return edges;
}

std::vector<EdgeBearing> look_at_edges(std::span<const Point<Field>> edges,
                                       const Pose<Field, Robot>& X_FR,
                                       const EdgeView& view,
                                       std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, view.sigma);
  std::vector<EdgeBearing> bearings;
  for (const Point<Field>& edge : edges) {
    const Eigen::Vector2d p = (X_FR.inverse() * edge).vector() - view.shift_R;
    if (p.norm() > view.range) continue;
    bearings.push_back({wrap_angle(std::atan2(p.y(), p.x()) + noise(random))});
  }
  return bearings;
}

Triangulation::Triangulation(std::vector<Point<Field>> edges, double sigma)
    : edges_(std::move(edges)),
      sigma_(sigma) {}

void Triangulation::begin(const Pose<Field, Robot>& X_FR, const Eigen::Matrix3d& cov) {
  X_FR_ = X_FR;
  cov_ = cov;
}

void Triangulation::move(const Pose<Robot, Robot>& step, const Eigen::Matrix3d& cov_step) {
  const Eigen::Vector2d way = X_FR_.rotation() * Eigen::Vector2d(step.x(), step.y());
  Eigen::Matrix3d by_pose = Eigen::Matrix3d::Identity();
  by_pose(0, 2) = -way.y();
  by_pose(1, 2) = way.x();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = X_FR_.rotation();
  cov_ = by_pose * cov_ * by_pose.transpose() + turn * cov_step * turn.transpose();
  X_FR_ = X_FR_ * step;
}

void Triangulation::see(std::span<const EdgeBearing> bearings) {
  for (const EdgeBearing& bearing : bearings) {
    double least = kGate;
    double gap = 0.0;
    double variance = 1.0;
    Eigen::Vector3d row = Eigen::Vector3d::Zero();
    for (const Point<Field>& edge : edges_) {
      const Eigen::Vector2d d = edge.vector() - X_FR_.origin().vector();
      const double r2 = d.squaredNorm();
      const Eigen::Vector3d slope(d.y() / r2, -d.x() / r2, -1.0);
      const double expected = std::atan2(d.y(), d.x()) - X_FR_.theta();
      const double difference = wrap_angle(bearing.azimuth - expected);
      const double expected_var = slope.dot(cov_ * slope) + sigma_ * sigma_;
      if (difference * difference / expected_var >= least) continue;
      least = difference * difference / expected_var;
      gap = difference;
      variance = expected_var;
      row = slope;
    }
    if (least >= kGate) continue;
    const Eigen::Vector3d gain = cov_ * row / variance;
    const Eigen::Vector3d change = gain * gap;
    X_FR_ = {X_FR_.x() + change.x(), X_FR_.y() + change.y(), X_FR_.theta() + change.z()};
    cov_ -= gain * row.transpose() * cov_;
    cov_ = 0.5 * (cov_ + cov_.transpose()).eval();
  }
}

}  // namespace teamsight::locate_rivals
