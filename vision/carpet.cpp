// vision/carpet.cpp: median luminance and mean chroma of the green samples.
#include "vision/carpet.hpp"

#include <numeric>

namespace teamsight::vision {

Carpet CarpetMeter::carpet() const {
  const std::size_t green = std::accumulate(histogram_.begin(), histogram_.end(), std::size_t{0});
  if (green == 0 || samples_ == 0) return {};
  Carpet carpet;
  std::size_t below = 0;
  std::size_t median = 0;
  while (2 * (below + histogram_[median]) < green) below += histogram_[median++];
  const auto count = static_cast<float>(green);
  carpet.luminance = static_cast<float>(median);
  carpet.u = static_cast<float>(sum_u_) / count - 128.0F;
  carpet.v = static_cast<float>(sum_v_) / count - 128.0F;
  carpet.share = count / static_cast<float>(samples_);
  return carpet;
}

}  // namespace teamsight::vision
