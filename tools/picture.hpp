// tools/picture.hpp: a picture in memory, for drawings.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tools/image_file.hpp"

namespace teamsight::tools {

/// Row by row blue, green and red of each pixel, nothing between the rows.
struct Picture {
  int width_px{0};
  int height_px{0};
  std::vector<std::uint8_t> bgr;
};

/// A frame of any format in colour, as many pixels.
[[nodiscard]] Picture picture_of(const ImageFile& frame);

/// Both beside each other, on black where one is lower.
[[nodiscard]] Picture beside(const Picture& left, const Picture& right);

/// The file's extension says the format: .png and the like.
///
/// @throws std::runtime_error if the file cannot be written
void write_picture(const std::filesystem::path& path, const Picture& picture);

}  // namespace teamsight::tools
