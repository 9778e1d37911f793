// bench/peers/obstacle_rules.hpp: how other teams share obstacles, to be compared with.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fusion/assignment.hpp"
#include "fusion/observation.hpp"
#include "fusion/planar_filter.hpp"
#include "geometry/identity.hpp"

namespace teamsight::peers {

struct ObstacleGuess {
  std::uint32_t id{0};  ///< 0: the rule has no ids
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};
};

/// NuBot: constant-velocity information filters, to which every robot's sightings are added (1 m
/// along, 5 degrees across the line of sight); auction within 1.5 m; shown after 15 hits.
class InformationFilterObstacles {
 public:
  void take(const fusion::Observation& observation, double t, double robot_radius);

  [[nodiscard]] std::vector<ObstacleGuess> obstacles(double now) const;

 private:
  struct Track {
    std::uint32_t id{0};
    fusion::PlanarMoments moments;
    double time{0.0};
    double last_hit{0.0};
    int hits{0};
  };

  [[nodiscard]] std::vector<Eigen::Vector2d> strangers(const fusion::Observation& observation,
                                                       double t,
                                                       double robot_radius) const;
  [[nodiscard]] fusion::Assignment auction(const std::vector<Eigen::Vector2d>& sighted) const;
  void take_one(const Eigen::Vector2d& p_F, const Eigen::Vector2d& observer_F, Track& track) const;

  std::vector<Track> tracks_;
  std::array<Eigen::Vector2d, kMaxRobotId> mates_F_{};
  std::array<double, kMaxRobotId> mate_seen_{};
  std::uint32_t next_id_{1};
  double time_{0.0};
};

/// CAMBADA: an obstacle counts when two robots report it within the last second; no ids.
class TwoWitnessObstacles {
 public:
  void take(const fusion::Observation& observation, double t, double robot_radius);

  [[nodiscard]] std::vector<ObstacleGuess> obstacles(double now) const;

 private:
  struct View {
    double time{-1e9};
    Eigen::Vector2d self_F{Eigen::Vector2d::Zero()};
    std::vector<Eigen::Vector2d> obstacles_F;
  };

  [[nodiscard]] bool is_mate(const Eigen::Vector2d& p_F, double now) const;

  std::array<View, kMaxRobotId> views_;
};

}  // namespace teamsight::peers
