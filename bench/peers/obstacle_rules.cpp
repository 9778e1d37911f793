// bench/peers/obstacle_rules.cpp: see bench/peers/obstacle_rules.hpp.
#include "bench/peers/obstacle_rules.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::peers {
namespace {

constexpr double kGate = 1.5;  // m
constexpr int kBirthHits = 15;
constexpr double kForget = 1.0;                 // s
constexpr double kMate = 0.5;                   // m around a mate's own posture
const fusion::PlanarMotion kMotion{0.25, 0.0};  // (0.5 m/s)^2 per second
constexpr double kSameThing = 0.5;              // m; CAMBADA: of one obstacle in two reports
constexpr double kFarthest = 6.0;               // m; CAMBADA uses none beyond

Eigen::Vector2d centre_of(const ObstacleSighting& sighting,
                          const Pose<Field, Robot>& X_FR,
                          double radius) {
  const Eigen::Vector2d foot_R = sighting.p_RO.vector();
  const double distance = std::max(1e-6, foot_R.norm());
  return (X_FR * Point<Robot>::from(foot_R * (1.0 + radius / distance))).vector();
}

std::size_t index_of(RobotId robot) {
  return static_cast<std::size_t>(robot) - 1U;
}

/// What several robots report in one place.
struct Cluster {
  Eigen::Vector2d sum{Eigen::Vector2d::Zero()};
  int count{0};
  unsigned witnesses{0};
};

/// The one that this place belongs to; a fresh one if there is none.
Cluster& cluster_at(const Eigen::Vector2d& p_F, std::vector<Cluster>& clusters) {
  const auto near = std::find_if(clusters.begin(), clusters.end(), [&](const Cluster& cluster) {
    return (cluster.sum / cluster.count - p_F).norm() < kSameThing;
  });
  return near == clusters.end() ? clusters.emplace_back() : *near;
}

}  // namespace

void InformationFilterObstacles::take_one(const Eigen::Vector2d& p_F,
                                          const Eigen::Vector2d& observer_F,
                                          Track& track) const {
  const Eigen::Vector2d way = p_F - observer_F;
  const double angle = std::atan2(way.y(), way.x());
  const double across = way.norm() * 0.0873;
  const Eigen::Matrix2d turn =
      (Eigen::Matrix2d() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle))
          .finished();
  const Eigen::Vector2d var(1.0, std::max(1e-4, across * across));
  fusion::PlanarFilter filter = fusion::PlanarFilter::from(track.moments);
  filter.update({p_F, turn * var.asDiagonal() * turn.transpose()});
  track.moments = filter.moments();
  track.last_hit = time_;
  ++track.hits;
}

std::vector<Eigen::Vector2d> InformationFilterObstacles::strangers(
    const fusion::Observation& observation, double t, double robot_radius) const {
  std::vector<Eigen::Vector2d> sighted;
  for (const ObstacleSighting& sighting : observation.obstacles) {
    const Eigen::Vector2d p_F = centre_of(sighting, observation.posture.X_FR, robot_radius);
    bool is_mate = false;
    for (std::size_t i = 0; i < mates_F_.size(); ++i) {
      is_mate = is_mate || (mate_seen_[i] > 0.0 && t - mate_seen_[i] < kForget &&
                            (mates_F_[i] - p_F).norm() < kMate);
    }
    if (!is_mate && sighted.size() < kMaxObstacleSightings) sighted.push_back(p_F);
  }
  return sighted;
}

fusion::Assignment InformationFilterObstacles::auction(
    const std::vector<Eigen::Vector2d>& sighted) const {
  fusion::CostMatrix cost(static_cast<Eigen::Index>(sighted.size()),
                          static_cast<Eigen::Index>(tracks_.size()));
  cost.setConstant(fusion::kForbidden);
  for (std::size_t row = 0; row < sighted.size(); ++row) {
    for (std::size_t column = 0; column < tracks_.size(); ++column) {
      const double distance = (sighted[row] - tracks_[column].moments.mean.head<2>()).norm();
      if (distance >= kGate) continue;
      cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = distance;
    }
  }
  return fusion::assign(cost, 100.0);
}

void InformationFilterObstacles::take(const fusion::Observation& observation,
                                      double t,
                                      double robot_radius) {
  const Eigen::Vector2d self_F = observation.posture.X_FR.origin().vector();
  mates_F_[index_of(observation.id.robot)] = self_F;
  mate_seen_[index_of(observation.id.robot)] = t;
  time_ = std::max(time_, t);
  for (Track& track : tracks_) {
    track.moments = fusion::predicted(track.moments, time_ - track.time, kMotion);
    track.time = time_;
  }
  const auto sighted = strangers(observation, t, robot_radius);
  const auto assignment = auction(sighted);
  for (std::size_t row = 0; row < sighted.size(); ++row) {
    if (assignment[row] != fusion::kUnassigned) {
      take_one(sighted[row], self_F, tracks_[static_cast<std::size_t>(assignment[row])]);
    } else if (tracks_.size() < static_cast<std::size_t>(fusion::kMaxAssignmentColumns)) {
      Track track;
      track.id = next_id_++;
      track.time = track.last_hit = time_;
      track.moments.mean << sighted[row], 0.0, 0.0;
      track.moments.cov = Eigen::Vector4d(1.0, 1.0, 1.0, 1.0).asDiagonal();
      track.hits = 1;
      tracks_.push_back(track);
    }
  }
  std::erase_if(tracks_, [&](const Track& track) { return time_ - track.last_hit > kForget; });
}

std::vector<ObstacleGuess> InformationFilterObstacles::obstacles(double now) const {
  std::vector<ObstacleGuess> guesses;
  for (const Track& track : tracks_) {
    if (track.hits < kBirthHits || now - track.last_hit > kForget) continue;
    const auto moments = fusion::predicted(track.moments, now - track.time, kMotion);
    guesses.push_back({track.id, moments.mean.head<2>()});
  }
  return guesses;
}

void TwoWitnessObstacles::take(const fusion::Observation& observation,
                               double t,
                               double robot_radius) {
  View& view = views_[index_of(observation.id.robot)];
  if (t < view.time) return;
  view.time = t;
  view.self_F = observation.posture.X_FR.origin().vector();
  view.obstacles_F.clear();
  for (const ObstacleSighting& sighting : observation.obstacles) {
    if (sighting.p_RO.vector().norm() > kFarthest) continue;
    view.obstacles_F.push_back(centre_of(sighting, observation.posture.X_FR, robot_radius));
  }
}

bool TwoWitnessObstacles::is_mate(const Eigen::Vector2d& p_F, double now) const {
  return std::any_of(views_.begin(), views_.end(), [&](const View& view) {
    return now - view.time < kForget && (view.self_F - p_F).norm() < kMate;
  });
}

std::vector<ObstacleGuess> TwoWitnessObstacles::obstacles(double now) const {
  std::vector<Cluster> clusters;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    if (now - views_[i].time > kForget) continue;
    for (const Eigen::Vector2d& p_F : views_[i].obstacles_F) {
      if (is_mate(p_F, now)) continue;
      Cluster& cluster = cluster_at(p_F, clusters);
      cluster.sum += p_F;
      ++cluster.count;
      cluster.witnesses |= 1U << i;
    }
  }
  std::vector<ObstacleGuess> guesses;
  for (const Cluster& cluster : clusters) {
    const bool is_confirmed = (cluster.witnesses & (cluster.witnesses - 1U)) != 0;
    if (is_confirmed) guesses.push_back({0, cluster.sum / cluster.count});
  }
  return guesses;
}

}  // namespace teamsight::peers
