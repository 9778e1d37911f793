// agent/still_frames.hpp: pictures from files: raw dumps of a camera, PNG and JPEG.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "agent/frame_source.hpp"

namespace teamsight::agent {

/// What a raw dump must be, because the file does not say.
struct PictureLayout {
  std::uint32_t width_px{0};
  std::uint32_t height_px{0};
  vision::PixelFormat format{vision::PixelFormat::kUyvy};
};

/// Reads a picture without a header.
///
/// @throws SourceError if the file cannot be read or has another size than `layout` needs
[[nodiscard]] Frame read_raw_dump(const std::string& path, const PictureLayout& layout);

/// Gives these frames one after the other, whenever asked, stamped with the present.
///
/// @param loop    begin again after the last; else it is finished then
/// @pre `frames` is not empty
[[nodiscard]] std::unique_ptr<FrameSource> make_still_frames(std::vector<Frame> frames, bool loop);

}  // namespace teamsight::agent
