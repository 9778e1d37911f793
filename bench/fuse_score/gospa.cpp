// bench/fuse_score/gospa.cpp: see bench/fuse_score/gospa.hpp.
#include "bench/fuse_score/gospa.hpp"

#include <algorithm>

#include "fusion/assignment.hpp"

namespace teamsight::score {
namespace {

constexpr double kCutOff = 1.0;  // m

}  // namespace

GospaMatch match_gospa(const std::vector<Eigen::Vector2d>& truths,
                       const std::vector<bool>& needed,
                       const std::vector<Eigen::Vector2d>& estimates) {
  const auto rows = std::min(truths.size(), static_cast<std::size_t>(fusion::kMaxAssignmentRows));
  const auto columns =
      std::min(estimates.size(), static_cast<std::size_t>(fusion::kMaxAssignmentColumns));
  fusion::CostMatrix cost(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  cost.setConstant(fusion::kForbidden);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double squared = (truths[row] - estimates[column]).squaredNorm();
      if (squared >= kCutOff * kCutOff) continue;
      cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = squared;
    }
  }
  // Leaving a pair apart costs c^2 / 2 for each of the two.
  const auto assignment = fusion::assign(cost, kCutOff * kCutOff);
  GospaMatch match;
  match.truth_of.assign(estimates.size(), -1);
  int free_ones = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    if (assignment[row] == fusion::kUnassigned) {
      if (needed[row]) ++match.gospa.missed;
      continue;
    }
    const auto column = static_cast<std::size_t>(assignment[row]);
    match.truth_of[column] = static_cast<int>(row);
    if (!needed[row]) {
      ++free_ones;
      continue;
    }
    ++match.gospa.matched;
    match.gospa.localisation += (truths[row] - estimates[column]).squaredNorm();
  }
  match.gospa.false_ones = static_cast<int>(estimates.size()) - match.gospa.matched - free_ones;
  return match;
}

}  // namespace teamsight::score
