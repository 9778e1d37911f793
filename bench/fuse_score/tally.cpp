// bench/fuse_score/tally.cpp: see bench/fuse_score/tally.hpp.
#include "bench/fuse_score/tally.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace teamsight::score {

void ErrorTally::add(double squared) {
  squares_.push_back(squared);
}

double ErrorTally::rms() const {
  if (squares_.empty()) return 0.0;
  const double sum = std::accumulate(squares_.begin(), squares_.end(), 0.0);
  return std::sqrt(sum / static_cast<double>(squares_.size()));
}

double ErrorTally::quantile(double share) const {
  if (squares_.empty()) return 0.0;
  std::vector<double> sorted = squares_;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
  return std::sqrt(sorted[static_cast<std::size_t>(at)]);
}

double ErrorTally::share_within(double size) const {
  if (squares_.empty()) return 0.0;
  const auto within = std::count_if(
      squares_.begin(), squares_.end(), [&](double square) { return square < size * size; });
  return static_cast<double>(within) / static_cast<double>(squares_.size());
}

void ErrorTally::merge(const ErrorTally& other) {
  squares_.insert(squares_.end(), other.squares_.begin(), other.squares_.end());
}

namespace {

void merge_ball(BallTally& into, const BallTally& from) {
  into.needed += from.needed;
  into.position.merge(from.position);
  into.velocity.merge(from.velocity);
  into.high.merge(from.high);
  into.bound_position.merge(from.bound_position);
  into.bound_velocity.merge(from.bound_velocity);
  into.bound_high.merge(from.bound_high);
  into.nees_position.merge(from.nees_position);
  into.nees_velocity.merge(from.nees_velocity);
  into.second_balls += from.second_balls;
}

void merge_obstacles(ObstacleTally& into, const ObstacleTally& from) {
  into.gospa.merge(from.gospa);
  into.localisation.merge(from.localisation);
  into.missed.merge(from.missed);
  into.false_ones.merge(from.false_ones);
  into.nees.merge(from.nees);
  into.switches += from.switches;
  into.false_tracks += from.false_tracks;
}

void append(std::vector<double>& into, const std::vector<double>& from) {
  into.insert(into.end(), from.begin(), from.end());
}

void merge_trust(TrustTally& into, const TrustTally& from) {
  append(into.found_after, from.found_after);
  append(into.found_after_evidence, from.found_after_evidence);
  append(into.over_after, from.over_after);
  into.not_found += from.not_found;
  into.wrong_reason += from.wrong_reason;
  into.false_alarms += from.false_alarms;
}

}  // namespace

void Tally::merge(const Tally& other) {
  merge_ball(ball, other.ball);
  merge_obstacles(obstacles, other.obstacles);
  mates.position.merge(other.mates.position);
  mates.said.merge(other.mates.said);
  mates.nees.merge(other.mates.nees);
  merge_trust(trust, other.trust);
  insert_us.merge(other.insert_us);
  minutes += other.minutes;
}

}  // namespace teamsight::score
