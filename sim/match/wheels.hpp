// sim/match/wheels.hpp: what a robot's wheels count, with their faults.
#pragma once

#include "geometry/frames.hpp"
#include "geometry/pose.hpp"
#include "sim/match/players.hpp"
#include "sim/match/random.hpp"

namespace teamsight::sim {

struct WheelParameters {
  double sigma_scale{0.02};       ///< of the constant scale factors of way and turn; dimensionless
  double sigma_turn_bias{0.005};  ///< of the constant error of the turn rate; rad/s
  double sigma_v{0.03};           ///< of each velocity reading; m/s
  double sigma_omega{0.03};       ///< rad/s
};

/// Counts one robot's way in frame D, which drifts away from F. Where the wheels slip it counts
/// what they turn, not how the body moves.
class Wheels {
 public:
  Wheels(const WheelParameters& parameters, std::uint32_t seed);

  /// The robot moved like this for `seconds`.
  void roll(const Player& player, double seconds);

  /// X_DR: where the wheels take the robot to be since they began to count.
  [[nodiscard]] const Pose<Drive, Robot>& pose() const { return X_DR_; }

  /// As the wheels read it; m/s.
  [[nodiscard]] const Velocity<Robot>& velocity() const { return v_R_; }

  /// rad/s
  [[nodiscard]] double omega() const { return omega_; }

 private:
  WheelParameters parameters_;
  Random random_;
  double way_scale_;
  double turn_scale_;
  double turn_bias_;
  Pose<Drive, Robot> X_DR_;
  Velocity<Robot> v_R_;
  double omega_{0.0};
};

}  // namespace teamsight::sim
