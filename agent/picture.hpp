// agent/picture.hpp: a frame as a small JPEG, for the coach's page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vision/image.hpp"

namespace teamsight::agent {

/// What a thumbnail shows.
struct Picture {
  std::uint16_t width_px{0};
  std::uint16_t height_px{0};
  std::vector<std::uint8_t> jpeg;  ///< at most kMostPictureBytes
};

inline constexpr std::uint32_t kWidestPicture = 320;      // px
inline constexpr std::size_t kMostPictureBytes = 32'768;  // what the topic holds

/// Compresses every n-th pixel of a frame, so that it is at most kWidestPicture wide. A frame's
/// luminance and chroma go into the JPEG as they are, without a detour over colours.
///
/// Allocates; only for what somebody has asked for.
///
/// @pre is_whole(frame)
/// @return nothing if the compressor refuses, or the result is larger than the topic holds
[[nodiscard]] std::optional<Picture> picture_of(const vision::ImageView& frame);

}  // namespace teamsight::agent
