// vision/mirror_parts.hpp: which part of a mirror of several each pixel looks at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vision/camera_model.hpp"
#include "vision/ray_table.hpp"

namespace teamsight::vision {

/// A mirror whose meridian has a kink shows some of the world twice: where lines of sight jump from
/// one pixel to the next, another part begins.
class MirrorParts {
 public:
  static constexpr std::uint8_t kInner = 0;   ///< the part at the image centre
  static constexpr std::uint8_t kNone = 255;  ///< it sees nothing

  /// @param centre  of the mirror in the image
  MirrorParts(const RayTable& rays, const Pixel& centre);

  /// Whether there is a part besides the inner one.
  [[nodiscard]] bool are_several() const { return !parts_.empty(); }

  /// The part of a pixel (row * width + column); kInner of all if that is the only one.
  [[nodiscard]] std::uint8_t operator[](std::size_t pixel) const {
    return parts_.empty() ? kInner : parts_[pixel];
  }

  /// Whether a pixel lies so near to where its part ends that blur mixes both.
  [[nodiscard]] bool is_seam(std::size_t pixel, std::size_t width) const;

 private:
  std::vector<std::uint8_t> parts_;  // of each pixel; empty: all are of one
};

}  // namespace teamsight::vision
