// vision/trait_model.hpp: how probably something with given traits is what is looked for.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace teamsight::vision {

/// Log-odds as a weighted sum of traits.
template <std::size_t kSize>
struct TraitModel {
  std::array<double, kSize> weights{};
  double bias{0.0};
  double least{0.5};  ///< probability from which it is reported

  friend bool operator==(const TraitModel&, const TraitModel&) = default;
};

/// In [0, 1].
template <std::size_t kSize>
[[nodiscard]] double probability(const TraitModel<kSize>& model,
                                 const std::array<double, kSize>& traits) {
  double log_odds = model.bias;
  for (std::size_t i = 0; i < kSize; ++i) log_odds += model.weights[i] * traits[i];
  return 1.0 / (1.0 + std::exp(-log_odds));
}

}  // namespace teamsight::vision
