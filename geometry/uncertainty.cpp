// geometry/uncertainty.cpp: checks and distances for covariances.
#include "geometry/uncertainty.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

#include "geometry/expect.hpp"

namespace teamsight {

namespace {

// Bounded, so that neither check nor distance allocates: both run for every observation.
using BoundedMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxStateSize, kMaxStateSize>;
using BoundedVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxStateSize, 1>;

// Measured against the two standard deviations, so that small parts beside large ones count too.
bool is_symmetric(const Eigen::Ref<const Eigen::MatrixXd>& cov) {
  constexpr double kRounding = 1e-6;  // what float32 on the wire leaves
  for (Eigen::Index i = 0; i < cov.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const double scale = std::sqrt(cov(i, i) * cov(j, j));
      if (std::abs(cov(i, j) - cov(j, i)) > kRounding * scale) return false;
    }
  }
  return true;
}

// Probability that a chi-square variable exceeds `value`: the closed sums for whole degrees of
// freedom, sum of h^i / i! (even) or h^(i + 1/2) / (i + 1/2)! (odd), times exp(-h), with h =
// value/2.
double chi_square_tail(int degrees_of_freedom, double value) {
  const double half = 0.5 * value;
  const bool is_odd = degrees_of_freedom % 2 == 1;
  double power = is_odd ? 0.5 : 0.0;
  double term = std::exp(-half) * (is_odd ? 2.0 * std::sqrt(half * std::numbers::inv_pi) : 1.0);
  double tail = is_odd ? std::erfc(std::sqrt(half)) : 0.0;
  for (int i = 0; i < degrees_of_freedom / 2; ++i) {
    tail += term;
    power += 1.0;
    term *= half / power;
  }
  return tail;
}

}  // namespace

bool is_covariance(const Eigen::Ref<const Eigen::MatrixXd>& cov) {
  constexpr double kSmallestVar = 1e-12;
  constexpr double kLargestVar = 1e12;
  if (cov.rows() == 0 || cov.rows() != cov.cols() || !cov.allFinite()) return false;
  TEAMSIGHT_EXPECT(cov.rows() <= kMaxStateSize);
  const auto vars = cov.diagonal();
  if (vars.minCoeff() < kSmallestVar || vars.maxCoeff() > kLargestVar) return false;
  return is_symmetric(cov) && Eigen::LLT<BoundedMatrix>(cov).info() == Eigen::Success;
}

double squared_mahalanobis(const Eigen::Ref<const Eigen::VectorXd>& difference,
                           const Eigen::Ref<const Eigen::MatrixXd>& cov) {
  TEAMSIGHT_EXPECT(difference.size() == cov.rows() && cov.rows() <= kMaxStateSize);
  BoundedVector whitened = difference;
  Eigen::LLT<BoundedMatrix>(cov).matrixL().solveInPlace(whitened);
  return whitened.squaredNorm();
}

double chi_square_gate(int degrees_of_freedom, double probability) {
  TEAMSIGHT_EXPECT(degrees_of_freedom >= 1 && probability > 0.0 && probability < 1.0);
  if (degrees_of_freedom == 2) return -2.0 * std::log1p(-probability);
  double low = 0.0;
  double high = degrees_of_freedom;
  while (chi_square_tail(degrees_of_freedom, high) > 1.0 - probability) high *= 2.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (chi_square_tail(degrees_of_freedom, middle) > 1.0 - probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace teamsight
