// vision/calibration/obstacle_training.hpp: what robots look like, learnt from labelled images.
#pragma once

#include <optional>
#include <span>

#include "vision/obstacle_model.hpp"

namespace teamsight::vision {

/// Something that stands in an image, and what a person says of it.
struct ObstacleSample {
  ObstacleTraits traits{};
  bool is_robot{false};
};

/// How a model is made from samples.
struct TrainingRules {
  double ridge{1.0};  ///< pull of each weight towards 0, per standard deviation of its trait
  double least{0.4};  ///< passed on to the model; half would favour the commoner class
};

/// Logistic regression: the most probable weights under a normal prior.
///
/// @return nothing without a sample of either kind
[[nodiscard]] std::optional<ObstacleModel> train_obstacle_model(
    std::span<const ObstacleSample> samples, const TrainingRules& rules = {});

}  // namespace teamsight::vision
