// sim/wheels.cpp: see wheels.hpp.
#include "sim/wheels.hpp"

namespace teamsight::sim {

Wheels::Wheels(const WheelParameters& parameters, std::uint32_t seed)
    : parameters_(parameters),
      random_(seed),
      way_scale_(1.0 + parameters.sigma_scale * normal()),
      turn_scale_(1.0 + parameters.sigma_scale * normal()) {}

// The sum of twelve uniform numbers: std::normal_distribution differs between libraries.
double Wheels::normal() {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) {
    sum += static_cast<double>(random_()) / 4294967296.0;
  }
  return sum;
}

void Wheels::roll(const Player& player, double seconds) {
  const Eigen::Vector2d v = player.X_FR.rotation().transpose() * player.v_FR.vector();
  v_R_ = {way_scale_ * v.x() + parameters_.sigma_v * normal(),
          way_scale_ * v.y() + parameters_.sigma_v * normal()};
  omega_ = turn_scale_ * player.omega + parameters_.sigma_omega * normal();
  X_DR_ = X_DR_ * Pose<Robot, Robot>(v_R_.x * seconds, v_R_.y * seconds, omega_ * seconds);
}

}  // namespace teamsight::sim
