// vision/posture_fit.hpp: robust Gauss-Newton of line points onto the painted lines.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.hpp"
#include "vision/line_map.hpp"
#include "vision/line_points.hpp"

namespace teamsight::vision {

/// How one line point disagrees with the painted field.
struct LineResidual {
  double distance{0.0};      ///< signed, to the nearest paint; m
  Eigen::Vector3d jacobian;  ///< d distance / d (x, y, theta)
  double var{1.0};           ///< of the point across that paint, as its detector claims; m^2
};

/// The residual of one point under a posture [Lauer05, with exact distances].
[[nodiscard]] LineResidual line_residual(const LineMap& map,
                                         const Pose<Field, Robot>& X_FR,
                                         const LinePoint& point);

/// Whether a point lies on the paint, as far as its uncertainty lets one tell: within three sigma,
/// but at least 50 mm (a line is wider) and at most 250 mm.
///
/// @param scale true sigma of the points over the claimed one, see PostureFit
[[nodiscard]] bool is_inlier(const LineResidual& residual, double scale);

/// What a fit found.
struct PostureFit {
  Pose<Field, Robot> X_FR;
  Eigen::Matrix3d cov{Eigen::Matrix3d::Identity()};  ///< m, m, rad; meaningless unless observable
  bool observable{false};  ///< the lines hold the robot in all three directions
  double scale{1.0};       ///< true sigma of the points over the claimed one
  double inlier_ratio{0.0};
  double support{0.0};  ///< sum of soft votes, at most the number of points; ranks candidates
};

/// Moves a posture until the line points lie on the lines.
///
/// Geman-McClure weights, their width annealed from 0.25 m to max(20 mm, 3 sigma), sigma measured
/// from the residuals. The covariance is the M-estimator's, inflated by the correlation of
/// neighbouring residuals. Buffers are the only state.
class PostureFitter {
 public:
  /// @param start near the answer: within some 0.3 m and 10 degrees
  /// @pre points is not empty
  [[nodiscard]] PostureFit fit(const LineMap& map,
                               std::span<const LinePoint> points,
                               const Pose<Field, Robot>& start);

 private:
  [[nodiscard]] double measure_scale(std::span<const LineResidual> residuals);
  void look(const LineMap& map, std::span<const LinePoint> points, const Pose<Field, Robot>& X_FR);
  [[nodiscard]] bool step(Pose<Field, Robot>& X_FR, double width, double scale) const;
  void judge(PostureFit& fit);

  std::vector<LineResidual> residuals_;
  std::vector<double> sorted_;
};

}  // namespace teamsight::vision
