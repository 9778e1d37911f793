// vision/calibration/trait_training.cpp: Newton's method on the penalised likelihood.
#include "vision/calibration/trait_training.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace teamsight::vision {

namespace {

constexpr int kSteps = 30;
constexpr double kConstant = 1e-6;  // a spread below it is none

// The last column, of ones, belongs to the bias and is not penalised.
Eigen::VectorXd fit(const Eigen::MatrixXd& x, const Eigen::VectorXd& y, double ridge) {
  Eigen::VectorXd penalty = Eigen::VectorXd::Constant(x.cols(), ridge);
  penalty(x.cols() - 1) = kConstant;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(x.cols());
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::ArrayXd p = 1.0 / (1.0 + (-(x * weights).array()).exp());
    const Eigen::VectorXd gradient =
        x.transpose() * (p.matrix() - y) + penalty.cwiseProduct(weights);
    Eigen::MatrixXd hessian = x.transpose() * (p * (1.0 - p)).matrix().asDiagonal() * x;
    hessian.diagonal() += penalty;
    weights -= hessian.ldlt().solve(gradient);
  }
  return weights;
}

}  // namespace

std::optional<Eigen::VectorXd> fit_weights(const Eigen::MatrixXd& traits,
                                           const Eigen::VectorXd& wanted,
                                           const TrainingRules& rules) {
  const auto n = static_cast<double>(wanted.size());
  if (wanted.size() == 0 || wanted.sum() == 0.0 || wanted.sum() == n) return std::nullopt;
  const Eigen::Index size = traits.cols();
  const Eigen::RowVectorXd mean = traits.colwise().mean();
  Eigen::MatrixXd x = Eigen::MatrixXd::Ones(traits.rows(), size + 1);
  x.leftCols(size) = traits.rowwise() - mean;
  const Eigen::RowVectorXd spread =
      (x.leftCols(size).colwise().squaredNorm() / n).cwiseSqrt().cwiseMax(kConstant);
  x.leftCols(size).array().rowwise() /= spread.array();

  Eigen::VectorXd weights = fit(x, wanted, rules.ridge);
  weights.head(size).array() /= spread.transpose().array();
  weights(size) -= mean * weights.head(size);
  return weights;
}

}  // namespace teamsight::vision
