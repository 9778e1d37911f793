// geometry/uncertainty.hpp: what may be called a covariance, and how far apart two estimates are.
#pragma once

#include <Eigen/Core>

namespace teamsight {

/// The largest state whose covariance these functions take; they never allocate.
inline constexpr int kMaxStateSize = 16;

/// Whether `cov` is finite, symmetric and positive definite, and no wider or narrower than a
/// number in this domain can be (standard deviations between 1e-6 and 1e6).
///
/// @param cov  any matrix; only one that is square and larger than kMaxStateSize is a mistake
[[nodiscard]] bool is_covariance(const Eigen::Ref<const Eigen::MatrixXd>& cov);

/// Squared Mahalanobis distance of `difference` under `cov`; dimensionless.
///
/// @pre `cov` is a covariance of the same size (is_covariance)
[[nodiscard]] double squared_mahalanobis(const Eigen::Ref<const Eigen::VectorXd>& difference,
                                         const Eigen::Ref<const Eigen::MatrixXd>& cov);

/// The value that a chi-square variable stays below with the given probability.
///
/// Exact to rounding: halves an interval on the closed form for whole degrees of freedom.
///
/// @param degrees_of_freedom  at least 1
/// @param probability         above 0 and below 1
[[nodiscard]] double chi_square_gate(int degrees_of_freedom, double probability);

}  // namespace teamsight
