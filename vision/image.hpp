// vision/image.hpp: a look at somebody else's pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// One frame's pixels, owned by whoever made it. Rows from top to bottom without gaps.
struct ImageView {
  std::span<const std::uint8_t> bytes;
  std::uint32_t width_px{0};
  std::uint32_t height_px{0};
  PixelFormat format{PixelFormat::kBgr};
};

/// Bytes that one row of `width_px` pixels takes.
[[nodiscard]] constexpr std::size_t row_bytes(PixelFormat format, std::uint32_t width_px) {
  switch (format) {
    case PixelFormat::kBgr:
      return std::size_t{3} * width_px;
    case PixelFormat::kYuyv:
    case PixelFormat::kUyvy:
      return std::size_t{2} * width_px;
    case PixelFormat::kGrey:
      return width_px;
  }
  return 0;
}

/// Whether the view holds exactly the pixels it claims.
[[nodiscard]] constexpr bool is_whole(const ImageView& image) {
  return image.width_px > 0 && image.height_px > 0 &&
         image.bytes.size() == row_bytes(image.format, image.width_px) * image.height_px;
}

}  // namespace teamsight::vision
