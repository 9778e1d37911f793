// vision/pattern_traits.cpp: the weights.
#include "vision/pattern_traits.hpp"

namespace teamsight::vision {

PatternModel trained_pattern_model() {
  PatternModel model;
  model.weights = {
      -53.25,  // too_small
      -21.23,  // too_large
      -22.19,  // scatter
      15.78,   // carpet
      -2.45,   // front
      -7.90,   // foreign
      2.54,    // mixture
      4.63,    // between
  };
  model.bias = -7.49;
  model.least = 0.5;
  return model;
}

}  // namespace teamsight::vision
