// geometry/pose.cpp: symmetry of the field and propagation of covariances through a pose.
#include "geometry/pose.hpp"

#include <numbers>

namespace teamsight {

Pose<Field, Robot> mirrored(const Pose<Field, Robot>& X_FR, const Point<Field>& centre) {
  return {2.0 * centre.x - X_FR.x(), 2.0 * centre.y - X_FR.y(), X_FR.theta() + std::numbers::pi};
}

Eigen::Matrix2d transform_covariance(const Pose<Field, Robot>& X_FR,
                                     const Eigen::Matrix3d& cov_X,
                                     const Point<Robot>& p_R,
                                     const Eigen::Matrix2d& cov_R) {
  const Eigen::Matrix2d rotation = X_FR.rotation();
  const Eigen::Vector2d arm_F = rotation * p_R.vector();
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << 1.0, 0.0, -arm_F.y(), 0.0, 1.0, arm_F.x();
  return rotation * cov_R * rotation.transpose() + jacobian * cov_X * jacobian.transpose();
}

}  // namespace teamsight
