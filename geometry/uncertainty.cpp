// geometry/uncertainty.cpp: checks and distances for covariances.
#include "geometry/uncertainty.hpp"

#include <cmath>

#include <Eigen/Cholesky>

#include "geometry/expect.hpp"

namespace teamsight {

bool is_covariance(const Eigen::Ref<const Eigen::MatrixXd>& cov) {
  constexpr double kSmallestVar = 1e-12;
  constexpr double kLargestVar = 1e12;
  if (cov.rows() == 0 || cov.rows() != cov.cols() || !cov.allFinite()) return false;
  const double scale = cov.diagonal().cwiseAbs().maxCoeff();
  if (cov.diagonal().minCoeff() < kSmallestVar || scale > kLargestVar) return false;
  if (!(cov - cov.transpose()).isZero(1e-6 * scale)) return false;
  return Eigen::LLT<Eigen::MatrixXd>(cov).info() == Eigen::Success;
}

double squared_mahalanobis(const Eigen::Ref<const Eigen::VectorXd>& difference,
                           const Eigen::Ref<const Eigen::MatrixXd>& cov) {
  TEAMSIGHT_EXPECT(difference.size() == cov.rows());
  return difference.dot(Eigen::LLT<Eigen::MatrixXd>(cov).solve(difference));
}

namespace {

// Inverse of the standard normal distribution by bisection on erfc: exact, and called once per gate.
double normal_quantile(double probability) {
  double low = -10.0;
  double high = 10.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double chi_square_gate(int degrees_of_freedom, double probability) {
  TEAMSIGHT_EXPECT(degrees_of_freedom >= 1 && probability > 0.0 && probability < 1.0);
  if (degrees_of_freedom == 1) return std::pow(normal_quantile(0.5 * (1.0 + probability)), 2);
  if (degrees_of_freedom == 2) return -2.0 * std::log1p(-probability);
  const double spread = 2.0 / (9.0 * degrees_of_freedom);
  return degrees_of_freedom *
         std::pow(1.0 - spread + normal_quantile(probability) * std::sqrt(spread), 3);
}

}  // namespace teamsight
