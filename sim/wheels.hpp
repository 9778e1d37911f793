// sim/wheels.hpp: what a robot's wheels count, with their faults.
#pragma once

#include <random>

#include "bus/messages.hpp"
#include "geometry/pose.hpp"
#include "sim/match.hpp"

namespace teamsight::sim {

struct WheelParameters {
  double sigma_scale{0.02};  ///< of the constant scale factors of way and turn; dimensionless
  double sigma_v{0.03};      ///< of each velocity reading; m/s
  double sigma_omega{0.03};  ///< rad/s
};

/// Counts one robot's way in a frame that drifts away from F.
class Wheels {
 public:
  Wheels(const WheelParameters& parameters, std::uint32_t seed);

  /// The robot moved like this for `seconds`.
  void roll(const Player& player, double seconds);

  /// X_DR: where the wheels take the robot to be since they began to count.
  [[nodiscard]] const Pose<bus::Drive, Robot>& pose() const { return X_DR_; }

  /// As the wheels read it; m/s.
  [[nodiscard]] const Velocity<Robot>& velocity() const { return v_R_; }

  /// rad/s
  [[nodiscard]] double omega() const { return omega_; }

 private:
  [[nodiscard]] double normal();

  WheelParameters parameters_;
  std::mt19937 random_;
  double way_scale_;
  double turn_scale_;
  Pose<bus::Drive, Robot> X_DR_;
  Velocity<Robot> v_R_;
  double omega_{0.0};
};

}  // namespace teamsight::sim
