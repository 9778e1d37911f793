// vision/pattern_traits.cpp: the weights.
#include "vision/pattern_traits.hpp"

namespace teamsight::vision {

double most_probable(const PatternModel& model, PatternTraits traits) {
  // Of each the better end of what it can be.
  traits[5] = model.weights[5] > 0.0 ? 1.0 : 0.0;
  traits[6] = model.weights[6] > 0.0 ? kMostMixture : 0.0;
  traits[7] = model.weights[7] > 0.0 ? 1.0 : 0.0;
  return probability(model, traits);
}

PatternModel trained_pattern_model() {
  PatternModel model;
  model.weights = {
      -40.08,  // too_small
      -27.22,  // too_large
      -19.50,  // scatter
      15.72,   // carpet
      -3.00,   // front
      -9.49,   // foreign
      15.56,   // mixture
      6.35,    // between
  };
  model.bias = -10.21;
  model.least = 0.5;
  return model;
}

}  // namespace teamsight::vision
