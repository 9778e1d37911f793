// tools/other_light.cpp: see tools/other_light.hpp.
#include "tools/other_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "tools/picture.hpp"

namespace teamsight::tools {

namespace {

constexpr std::uint32_t kNoiseSeed = 1;
constexpr std::size_t kChannels = 3;

using Bytes = std::vector<std::uint8_t>;

std::uint8_t shown(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

// One way: the neighbours lie `step` bytes before and after, in rows of `row` bytes where it is
// less. The first and the last keep what they are.
Bytes blurred(const Bytes& bytes, std::size_t step) {
  Bytes result = bytes;
  for (std::size_t i = step; i + step < bytes.size(); ++i) {
    result[i] =
        static_cast<std::uint8_t>((bytes[i - step] + 2 * bytes[i] + bytes[i + step] + 2) / 4);
  }
  return result;
}

}  // namespace

const std::vector<OtherLight>& other_lights() {
  static const std::vector<OtherLight> lights{
      {"0.7 as bright", {0.7, 0.7, 0.7}},
      {"0.85 as bright", {0.85, 0.85, 0.85}},
      {"1.15 as bright", {1.15, 1.15, 1.15}},
      {"1.3 as bright", {1.3, 1.3, 1.3}},
      {"red 0.9", {0.9, 1.0, 1.0}},
      {"red 1.1", {1.1, 1.0, 1.0}},
      {"green 0.9", {1.0, 0.9, 1.0}},
      {"green 1.1", {1.0, 1.1, 1.0}},
      {"blue 0.9", {1.0, 1.0, 0.9}},
      {"blue 1.1", {1.0, 1.0, 1.1}},
      {"red 0.8", {0.8, 1.0, 1.0}},
      {"red 1.2", {1.2, 1.0, 1.0}},
      {"green 0.8", {1.0, 0.8, 1.0}},
      {"green 1.2", {1.0, 1.2, 1.0}},
      {"blue 0.8", {1.0, 1.0, 0.8}},
      {"blue 1.2", {1.0, 1.0, 1.2}},
      {"warm", {1.15, 1.0, 0.8}},
      {"cold", {0.85, 1.0, 1.2}},
      {"noise 5", {}, 5.0},
      {"noise 10", {}, 10.0},
      {"blurred", {}, 0.0, true},
  };
  return lights;
}

ImageFile in_light(const ImageFile& picture, const OtherLight& light) {
  Picture colours = picture_of(picture);
  Bytes& bgr = colours.bgr;
  if (light.is_blurred) {
    bgr = blurred(blurred(bgr, kChannels), kChannels * picture.width_px);
  }
  const std::array<double, kChannels> gains{light.gains.blue, light.gains.green, light.gains.red};
  std::mt19937 random(kNoiseSeed);
  std::normal_distribution<double> noise(0.0, 1.0);
  for (std::size_t i = 0; i < bgr.size(); ++i) {
    double value = gains[i % kChannels] * bgr[i];
    if (light.noise > 0.0) value += light.noise * noise(random);
    bgr[i] = shown(value);
  }
  return {std::move(bgr), picture.width_px, picture.height_px, vision::PixelFormat::kBgr};
}

}  // namespace teamsight::tools
