// vision/calibration/obstacle_training.cpp: Newton's method on the penalised likelihood.
#include "vision/calibration/obstacle_training.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace teamsight::vision {

namespace {

constexpr int kSteps = 30;
constexpr double kConstant = 1e-6;  // a spread below it is none
constexpr auto kSize = static_cast<Eigen::Index>(kTraits);

Eigen::Map<const Eigen::RowVectorXd> row_of(const ObstacleSample& sample) {
  return {sample.traits.data(), kSize};
}

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

std::optional<ObstacleModel> train_obstacle_model(std::span<const ObstacleSample> samples,
                                                  const TrainingRules& rules) {
  const auto robots = std::ranges::count(samples, true, &ObstacleSample::is_robot);
  const auto n = static_cast<Eigen::Index>(samples.size());
  if (robots == 0 || robots == n) return std::nullopt;
  Eigen::MatrixXd x = Eigen::MatrixXd::Ones(n, kSize + 1);
  Eigen::VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const ObstacleSample& sample = samples[static_cast<std::size_t>(i)];
    x.row(i).head(kSize) = row_of(sample);
    y(i) = sample.is_robot ? 1.0 : 0.0;
  }
  auto traits = x.leftCols(kSize);
  const Eigen::RowVectorXd mean = traits.colwise().mean();
  traits.rowwise() -= mean;
  const Eigen::RowVectorXd spread =
      (traits.colwise().squaredNorm() / static_cast<double>(n)).cwiseSqrt().cwiseMax(kConstant);
  traits.array().rowwise() /= spread.array();

  const Eigen::VectorXd fitted = fit(x, y, rules.ridge);
  const Eigen::RowVectorXd weights = fitted.head(kSize).transpose().cwiseQuotient(spread);
  ObstacleModel model;
  std::copy_n(weights.data(), kTraits, model.weights.begin());
  model.bias = fitted(kSize) - weights.dot(mean);
  model.least = rules.least;
  return model;
}

}  // namespace teamsight::vision
