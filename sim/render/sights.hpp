// sim/render/sights.hpp: what every pixel looks along, worked out once.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sim/render/optics.hpp"

namespace teamsight::sim {

/// One pixel's line of sight in R; single precision, because there are a million.
struct Sight {
  float origin_x{0.0F};  ///< m
  float origin_y{0.0F};
  float origin_z{0.0F};
  float direction_x{0.0F};  ///< unit length
  float direction_y{0.0F};
  float direction_z{0.0F};
  float width{0.0F};    ///< of the pixel, sideways; rad
  float height{0.0F};   ///< of the pixel, up and down; rad
  float flat{0.0F};     ///< horizontal share of the direction
  float floor_x{0.0F};  ///< where it meets the floor; infinite if it does not; m
  float floor_y{0.0F};
  float reach{0.0F};       ///< how far from R's origin that is; m
  std::uint32_t pixel{0};  ///< row * width + column

  [[nodiscard]] bool sees_floor() const { return reach < 1e6F; }
};

/// The lines of sight of an image whose pixels are `fineness` times finer than the camera's.
class Sights {
 public:
  static constexpr std::size_t kBins = 720;  ///< of the azimuth, for finding what is in a sector

  Sights(const Optics& optics, std::uint32_t width, std::uint32_t height, int fineness);

  /// By pixel.
  [[nodiscard]] std::span<const Sight> all() const { return sights_; }

  /// Forgets the sights of these pixels (by pixel: true), because something fixed hides what they
  /// see.
  void forget(const std::vector<bool>& hidden);

  /// Calls `visit(sight)` for each sight that may meet something standing on the floor within
  /// `radius` around (x, y) in R.
  ///
  /// @param farthest  of the reaches that are asked for; m
  template <class Visit>
  void visit_sector(float x,
                    float y,
                    float radius,
                    Visit visit,
                    float farthest = std::numeric_limits<float>::infinity()) const;

  /// The bin of a direction; rad.
  [[nodiscard]] static std::size_t bin_of(double azimuth);

  [[nodiscard]] std::uint32_t width() const { return width_; }

  [[nodiscard]] std::uint32_t height() const { return height_; }

 private:
  void sort_into_bins();

  std::uint32_t width_;
  std::uint32_t height_;
  std::vector<Sight> sights_;
  // The same by bin, then by reach: what a sector visits lies side by side in memory.
  std::vector<Sight> by_bin_;
  std::vector<std::uint32_t> bin_starts_;  // of each bin in by_bin_, and the end
};

template <class Visit>
void Sights::visit_sector(float x, float y, float radius, Visit visit, float farthest) const {
  const double distance = std::sqrt(static_cast<double>(x * x + y * y));
  const double half = distance > static_cast<double>(radius) * 1.05
                          ? std::asin(static_cast<double>(radius) / distance)
                          : 3.2;
  // A few bins more on both sides: a mirror off the axis bends lines of sight out of their bin.
  constexpr std::size_t kMore = 4;
  const auto bins = static_cast<std::size_t>(half / 3.14159265358979 * kBins) + 2 * kMore + 1;
  const std::size_t first =
      bin_of(std::atan2(static_cast<double>(y), static_cast<double>(x)) - half);
  const float nearest = static_cast<float>(distance) - radius - 0.15F;
  for (std::size_t i = 0; i < std::min(bins, kBins); ++i) {
    const std::size_t bin = (first + kBins - kMore + i) % kBins;
    const auto begin = by_bin_.begin() + bin_starts_[bin];
    const auto end = by_bin_.begin() + bin_starts_[bin + 1];
    auto sight = std::partition_point(
        begin, end, [nearest](const Sight& one) { return one.reach < nearest; });
    for (; sight != end && sight->reach <= farthest; ++sight) {
      visit(*sight);
    }
  }
}

}  // namespace teamsight::sim
