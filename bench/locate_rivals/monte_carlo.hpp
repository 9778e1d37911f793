// bench/locate_rivals/monte_carlo.hpp: Monte Carlo localisation on line points.
#pragma once

#include <random>
#include <span>
#include <vector>

#include "bench/locate_rivals/distance_table.hpp"
#include "geometry/field_model.hpp"
#include "geometry/pose.hpp"
#include "vision/line_points.hpp"

namespace teamsight::locate_rivals {

struct MonteCarloParameters {
  std::size_t particles{500};
  double sigma_place{0.02};  ///< scatter of one step beside the wheels' way; m
  double sigma_turn{0.01};   ///< rad
  double sigma_point{0.10};  ///< of a line point in the likelihood; m
  double fails{0.2};         ///< share of points that are anything
  double independent{0.2};   ///< exponent: neighbouring points are alike
  double anywhere{0.01};     ///< share of particles drawn anew in each frame
};

/// A cloud of postures; low-variance resampling in every frame [Thrun05].
class MonteCarlo {
 public:
  MonteCarlo(const FieldModel& field, const MonteCarloParameters& parameters, std::uint32_t seed);

  /// All over the carpet.
  void scatter();

  /// Around one place. @param sigma  of x, y, theta; m, m, rad
  void gather(const Pose<Field, Robot>& X_FR, const Eigen::Vector3d& sigma);

  void move(const Pose<Robot, Robot>& step);

  void weigh(const DistanceTable& table, std::span<const vision::LinePoint> points);

  /// The mean of the particles around the heaviest part of the cloud.
  [[nodiscard]] Pose<Field, Robot> estimate() const;

 private:
  [[nodiscard]] Pose<Field, Robot> draw();

  FieldModel field_;
  MonteCarloParameters parameters_;
  std::mt19937 random_;
  std::vector<Pose<Field, Robot>> particles_;
  std::vector<double> log_weights_;
  std::vector<Pose<Field, Robot>> next_;
  Pose<Field, Robot> best_;
};

}  // namespace teamsight::locate_rivals
