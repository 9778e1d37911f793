// bench/fuse_score/gospa.hpp: how far a set of estimates is from the set of true places.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace teamsight::score {

/// GOSPA with p = 2, c = 1 m, alpha = 2 [Rahmathullah17], in its parts.
struct Gospa {
  double localisation{0.0};  ///< sum of squared distances of the matched pairs; m^2
  int matched{0};
  int missed{0};
  int false_ones{0};

  [[nodiscard]] double squared() const { return localisation + 0.5 * (missed + false_ones); }
};

struct GospaMatch {
  Gospa gospa;
  std::vector<int> truth_of;  ///< for each estimate its truth, or -1
};

/// @param needed  whether that truth counts as missed; one that nobody can know of does not, and
///                an estimate matched with it counts neither way
[[nodiscard]] GospaMatch match_gospa(const std::vector<Eigen::Vector2d>& truths,
                                     const std::vector<bool>& needed,
                                     const std::vector<Eigen::Vector2d>& estimates);

}  // namespace teamsight::score
