// vision/calibration/trait_training.hpp: what a thing looks like, learnt from labelled images.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "vision/trait_model.hpp"

namespace teamsight::vision {

/// Something in an image, and what a person says of it.
template <std::size_t kSize>
struct TraitSample {
  std::array<double, kSize> traits{};
  bool is_wanted{false};
};

/// How a model is made from samples.
struct TrainingRules {
  double ridge{1.0};  ///< pull of each weight towards 0, per standard deviation of its trait
};

/// Logistic regression: the most probable weights under a normal prior, the bias last.
///
/// @param traits  one row a sample
/// @param wanted  1 or 0 for each row
/// @return nothing without a sample of either kind
[[nodiscard]] std::optional<Eigen::VectorXd> fit_weights(const Eigen::MatrixXd& traits,
                                                         const Eigen::VectorXd& wanted,
                                                         const TrainingRules& rules);

/// @param least  passed on to the model
/// @return nothing without a sample of either kind
template <std::size_t kSize>
[[nodiscard]] std::optional<TraitModel<kSize>> train(std::span<const TraitSample<kSize>> samples,
                                                     double least,
                                                     const TrainingRules& rules = {}) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd traits(n, static_cast<Eigen::Index>(kSize));
  Eigen::VectorXd wanted(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const TraitSample<kSize>& sample = samples[static_cast<std::size_t>(i)];
    traits.row(i) = Eigen::Map<const Eigen::RowVectorXd>(sample.traits.data(), traits.cols());
    wanted(i) = sample.is_wanted ? 1.0 : 0.0;
  }
  const auto weights = fit_weights(traits, wanted, rules);
  if (!weights) return std::nullopt;
  TraitModel<kSize> model;
  std::copy_n(weights->data(), kSize, model.weights.begin());
  model.bias = (*weights)(traits.cols());
  model.least = least;
  return model;
}

}  // namespace teamsight::vision
