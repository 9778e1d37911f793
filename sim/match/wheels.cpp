// sim/match/wheels.cpp: see wheels.hpp.
#include "sim/match/wheels.hpp"

namespace teamsight::sim {

Wheels::Wheels(const WheelParameters& parameters, std::uint32_t seed)
    : parameters_(parameters),
      random_(seed),
      way_scale_(1.0 + random_.normal(parameters.sigma_scale)),
      turn_scale_(1.0 + random_.normal(parameters.sigma_scale)),
      turn_bias_(random_.normal(parameters.sigma_turn_bias)) {}

void Wheels::roll(const Player& player, double seconds) {
  const Eigen::Vector2d v = player.X_FR.rotation().transpose() * player.wheels_F.vector();
  v_R_ = {way_scale_ * v.x() + random_.normal(parameters_.sigma_v),
          way_scale_ * v.y() + random_.normal(parameters_.sigma_v)};
  omega_ = turn_scale_ * player.omega + turn_bias_ + random_.normal(parameters_.sigma_omega);
  X_DR_ = X_DR_ * Pose<Robot, Robot>(v_R_.x * seconds, v_R_.y * seconds, omega_ * seconds);
}

}  // namespace teamsight::sim
