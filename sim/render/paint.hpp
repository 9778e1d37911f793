// sim/render/paint.hpp: colours as paint, and as light on its way to a sensor.
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace teamsight::sim {

/// What a camera at nominal exposure and light shows of a surface.
struct Paint {
  std::uint8_t red{0};
  std::uint8_t green{0};
  std::uint8_t blue{0};

  friend bool operator==(const Paint&, const Paint&) = default;
};

/// Linear light of red, green and blue, 1 = full scale of the sensor; the fourth is what it covers,
/// for layers that are laid over others.
using Light = Eigen::Array4f;

/// The camera's curve is taken as a square root, so light is the square of what it shows.
[[nodiscard]] inline Light light_of(const Paint& paint) {
  const auto linear = [](std::uint8_t value) {
    const float share = static_cast<float>(value) / 255.0F;
    return share * share;
  };
  return {linear(paint.red), linear(paint.green), linear(paint.blue), 1.0F};
}

/// A share (0 to 1) of `colour` over what is there.
inline void lay_over(Light& there, const Light& colour, float share) {
  there += share * (colour - there);
}

}  // namespace teamsight::sim
