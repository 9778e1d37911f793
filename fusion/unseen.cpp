// fusion/unseen.cpp: see fusion/unseen.hpp.
#include "fusion/unseen.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teamsight::fusion {
namespace {

// However well a place is watched, the watchers may be wrong about where they stand.
constexpr float kLeastShare = 1e-4F;
// Of a cell's obstacles, the largest share that leaves it in one step of the arithmetic.
constexpr double kLargestStep = 0.4;
// After so many steps everything has come from elsewhere: what was watched says nothing any more.
constexpr int kMostSteps = 64;

std::size_t index_of(int column, int row) {
  return static_cast<std::size_t>(row) * UnseenMap::kColumns + static_cast<std::size_t>(column);
}

Eigen::Vector2d cell_size(const Carpet& carpet) {
  return carpet.size.cwiseQuotient(Eigen::Vector2d(UnseenMap::kColumns, UnseenMap::kRows));
}

/// From the map's corner, in cells.
Eigen::Vector2d in_cells(const Eigen::Vector2d& p_F, const Carpet& carpet) {
  return (p_F - carpet.centre_F + 0.5 * carpet.size).cwiseQuotient(cell_size(carpet));
}

}  // namespace

Carpet Carpet::of(const FieldModel& field, double margin) {
  const double beyond = 2.0 * (field.surround + margin);
  return {field.centre.vector(), {field.length + beyond, field.width + beyond}};
}

UnseenMap::UnseenMap() {
  shares_.fill(1.0F);
}

void UnseenMap::wander_to(HostTime exposure,
                          const Carpet& carpet,
                          const NewcomerParameters& parameters) {
  const double dt = time_ == kNever ? 0.0 : to_seconds(exposure - time_);
  time_ = std::max(time_, exposure);
  if (dt <= 0.0) return;
  // Flow of things that move at `speed` into all directions out of a square.
  const double rate = 4.0 / std::numbers::pi * parameters.speed / cell_size(carpet).minCoeff();
  const int steps =
      static_cast<int>(std::min(std::ceil(rate * dt / kLargestStep), 1.0 * kMostSteps));
  if (steps == kMostSteps) return shares_.fill(1.0F);
  for (int step = 0; step < steps; ++step) wander(static_cast<float>(rate * dt / steps));
}

void UnseenMap::wander(float share) {
  const auto before = shares_;
  const auto at = [&](int column, int row) {
    const bool is_inside = column >= 0 && column < kColumns && row >= 0 && row < kRows;
    return is_inside ? before[index_of(column, row)] : 1.0F;
  };
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const float around = 0.25F * (at(column - 1, row) + at(column + 1, row) +
                                    at(column, row - 1) + at(column, row + 1));
      float& here = shares_[index_of(column, row)];
      here += share * (around - here);
    }
  }
}

void UnseenMap::watch(const Scene& scene, const Carpet& carpet, const TrackParameters& parameters) {
  const Eigen::Vector2d cell = cell_size(carpet);
  const Eigen::Vector2d observer_F = scene.glance.observer();
  const Eigen::Vector2d reach =
      Eigen::Vector2d::Constant(std::max(parameters.detection_range, Eyesight::kReach));
  const Eigen::Vector2d first = in_cells(observer_F - reach, carpet).cwiseMax(0.0);
  const Eigen::Vector2d last =
      in_cells(observer_F + reach, carpet).cwiseMin(Eigen::Vector2d(kColumns, kRows));
  for (int row = static_cast<int>(first.y()); row < static_cast<int>(std::ceil(last.y())); ++row) {
    for (int column = static_cast<int>(first.x()); column < static_cast<int>(std::ceil(last.x()));
         ++column) {
      const Eigen::Vector2d middle = Eigen::Vector2d(column + 0.5, row + 0.5).cwiseProduct(cell);
      const Eigen::Vector2d p_F = carpet.centre_F - 0.5 * carpet.size + middle;
      const double seen = missed_probability(p_F, scene, parameters);
      float& share = shares_[index_of(column, row)];
      share = std::max(kLeastShare, share * static_cast<float>(1.0 - seen));
    }
  }
}

double UnseenMap::share_at(const Eigen::Vector2d& p_F, const Carpet& carpet) const {
  const Eigen::Vector2d at = in_cells(p_F, carpet);
  const auto column = static_cast<int>(std::floor(at.x()));
  const auto row = static_cast<int>(std::floor(at.y()));
  if (column < 0 || column >= kColumns || row < 0 || row >= kRows) return 1.0;
  return static_cast<double>(shares_[index_of(column, row)]);
}

double doubt_of_newcomer(double share, double detected, const Parameters& parameters) {
  const NewcomerParameters& newcomer = parameters.newcomer;
  const double real = newcomer.density * share * std::max(detected, newcomer.least_detected);
  const double odds = std::log(real / newcomer.lasting_density);
  return std::clamp(parameters.obstacle.most_vote - odds, 0.0, newcomer.most_doubt);
}

}  // namespace teamsight::fusion
