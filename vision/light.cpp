// vision/light.cpp: mean, spread and saturation of the floor's luminance.
#include "vision/light.hpp"

#include <cmath>

namespace teamsight::vision {

namespace {

constexpr std::size_t kStride = 4;         // samples; thousands are left, and tell as much
constexpr double kDarkMean = 16.0;         // grey levels; black level of a video signal
constexpr std::uint64_t kSaturated = 230;  // grey levels; the end of studio range, less noise
constexpr double kGlareShare = 0.3;        // of the floor
constexpr double kEvenSpread = 3.0;  // grey levels, one sigma: less than any carpet with lines

}  // namespace

void LightMeter::add(std::span<const std::uint8_t> profile) {
  for (std::size_t i = 0; i < profile.size(); i += kStride) {
    const std::uint64_t value = profile[i];
    sum_ += value;
    sum_square_ += value * value;
    if (value >= kSaturated) ++saturated_;
  }
  count_ += (profile.size() + kStride - 1) / kStride;
}

Light LightMeter::light() const {
  if (count_ == 0) return Light::kUnknown;
  const auto count = static_cast<double>(count_);
  const double mean = static_cast<double>(sum_) / count;
  const double var = static_cast<double>(sum_square_) / count - mean * mean;
  if (mean < kDarkMean) return Light::kDark;
  if (static_cast<double>(saturated_) > kGlareShare * count) return Light::kGlare;
  return var < kEvenSpread * kEvenSpread ? Light::kCovered : Light::kGood;
}

}  // namespace teamsight::vision
