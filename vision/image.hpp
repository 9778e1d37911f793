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

[[nodiscard]] constexpr bool is_bayer(PixelFormat format) {
  return format >= PixelFormat::kBayerRggb;
}

/// Bytes that one row of `width_px` pixels takes; of NV12 the luminance alone.
[[nodiscard]] constexpr std::size_t row_bytes(PixelFormat format, std::uint32_t width_px) {
  switch (format) {
    case PixelFormat::kBgr:
      return std::size_t{3} * width_px;
    case PixelFormat::kYuyv:
    case PixelFormat::kUyvy:
      return std::size_t{2} * width_px;
    default:
      return width_px;
  }
}

/// Bytes that a whole frame takes.
[[nodiscard]] constexpr std::size_t frame_bytes(PixelFormat format,
                                                std::uint32_t width_px,
                                                std::uint32_t height_px) {
  const std::size_t rows = row_bytes(format, width_px) * height_px;
  return format == PixelFormat::kNv12 ? rows + rows / 2 : rows;
}

/// Whether pixels share their chroma in such a way that the size must be even.
[[nodiscard]] constexpr bool has_even_size(PixelFormat format,
                                           std::uint32_t width_px,
                                           std::uint32_t height_px) {
  switch (format) {
    case PixelFormat::kBgr:
    case PixelFormat::kGrey:
      return true;
    case PixelFormat::kYuyv:
    case PixelFormat::kUyvy:
      return width_px % 2 == 0;
    default:
      return width_px % 2 == 0 && height_px % 2 == 0;
  }
}

/// Whether the view holds exactly the pixels it claims, in a size that its format can have.
[[nodiscard]] constexpr bool is_whole(const ImageView& image) {
  return image.width_px > 0 && image.height_px > 0 &&
         has_even_size(image.format, image.width_px, image.height_px) &&
         image.bytes.size() == frame_bytes(image.format, image.width_px, image.height_px);
}

}  // namespace teamsight::vision
