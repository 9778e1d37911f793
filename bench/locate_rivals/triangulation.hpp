// bench/locate_rivals/triangulation.hpp: bearings to upright edges with an extended Kalman filter.
#pragma once

#include <random>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_model.hpp"
#include "geometry/pose.hpp"

namespace teamsight::locate_rivals {

/// The direction of an upright edge, which a mirror with an upright axis shows as a radial line.
struct EdgeBearing {
  double azimuth{0.0};  ///< in R; rad
};

/// Where upright edges stand: goal posts, and the ends of walls.
[[nodiscard]] std::vector<Point<Field>> upright_edges(const FieldModel& field);

/// How edges are looked at.
struct EdgeView {
  double range{0.0};  ///< m
  double sigma{0.0};  ///< of a bearing; rad
  /// Where the camera really is in the robot, which the method does not know; m.
  Eigen::Vector2d shift_R{Eigen::Vector2d::Zero()};
};

/// Bearings as a camera sees them.
[[nodiscard]] std::vector<EdgeBearing> look_at_edges(std::span<const Point<Field>> edges,
                                                     const Pose<Field, Robot>& X_FR,
                                                     const EdgeView& view,
                                                     std::mt19937& random);

/// Triangulation as a Kalman filter from bearings of unknown edges, each taken for the nearest
/// expected one within three sigma.
class Triangulation {
 public:
  Triangulation(std::vector<Point<Field>> edges, double sigma);

  /// @param cov of (x, y, theta); m, m, rad
  void begin(const Pose<Field, Robot>& X_FR, const Eigen::Matrix3d& cov);

  void move(const Pose<Robot, Robot>& step, const Eigen::Matrix3d& cov_step);

  void see(std::span<const EdgeBearing> bearings);

  [[nodiscard]] const Pose<Field, Robot>& estimate() const { return X_FR_; }

  [[nodiscard]] const Eigen::Matrix3d& cov() const { return cov_; }

 private:
  std::vector<Point<Field>> edges_;
  double sigma_;
  Pose<Field, Robot> X_FR_;
  Eigen::Matrix3d cov_{Eigen::Matrix3d::Identity()};
};

}  // namespace teamsight::locate_rivals
