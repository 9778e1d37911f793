// fusion/eyesight.cpp: see fusion/eyesight.hpp.
#include "fusion/eyesight.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::fusion {
namespace {

/// Of a thing at this distance, as given.
double given_probability(double distance, const TrackParameters& parameters) {
  const double near = std::max(0.0, 1.0 - distance / parameters.detection_range);
  return parameters.detection_probability * near;
}

}  // namespace

double Eyesight::probability(double distance,
                             const TrackParameters& parameters,
                             const EyesightParameters& eyesight) const {
  if (distance >= kReach) return given_probability(distance, parameters);
  const Ring& ring = rings_[static_cast<std::size_t>(distance / kRingWidth)];
  const double weight = eyesight.given_weight;
  const double learned =
      (weight * given_probability(distance, parameters) + static_cast<double>(ring.reported)) /
      (weight + static_cast<double>(ring.looked));
  return std::min(learned, eyesight.most);
}

double Eyesight::news_of(HostTime exposure, const EyesightParameters& parameters) const {
  const double since = to_seconds(exposure - time_) / to_seconds(parameters.look);
  return std::clamp(since, 0.0, 1.0);
}

void Eyesight::turn_to(HostTime exposure, const EyesightParameters& parameters) {
  const double dt = to_seconds(exposure - time_);
  if (dt <= 0.0) return;
  time_ = exposure;
  const auto keep = static_cast<float>(std::exp(-dt / to_seconds(parameters.memory)));
  for (Ring& ring : rings_) {
    ring.looked *= keep;
    ring.reported *= keep;
  }
}

void Eyesight::note(double distance, bool is_reported) {
  if (distance >= kReach) return;
  Ring& ring = rings_[static_cast<std::size_t>(distance / kRingWidth)];
  ring.looked += 1.0F;
  if (is_reported) ring.reported += 1.0F;
}

Shadow shadow_of(const Eigen::Vector2d& p_F, double radius, const Eigen::Vector2d& observer_F) {
  const Eigen::Vector2d way = p_F - observer_F;
  return {std::atan2(way.y(), way.x()), way.norm(), std::atan2(radius, way.norm())};
}

}  // namespace teamsight::fusion
