// tools/image_file.hpp: pictures and raw camera dumps as frames of one camera.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "vision/camera_parameters.hpp"
#include "vision/image.hpp"

namespace teamsight::tools {

/// A frame read from a file.
struct ImageFile {
  std::vector<std::uint8_t> bytes;
  std::uint32_t width_px{0};
  std::uint32_t height_px{0};
  vision::PixelFormat format{vision::PixelFormat::kBgr};

  /// Valid as long as this object is.
  [[nodiscard]] vision::ImageView view() const { return {bytes, width_px, height_px, format}; }
};

/// Whether the file is a dump of the camera's own bytes (extension .raw) rather than a picture.
[[nodiscard]] bool is_raw_dump(const std::filesystem::path& path);

/// The file itself; of a folder, its pictures and dumps (.png, .jpg, .jpeg, .bmp, .raw), by name.
///
/// @throws std::runtime_error if a folder has none, or cannot be read
[[nodiscard]] std::vector<std::filesystem::path> images_in(const std::filesystem::path& path);

/// Reads a frame that `camera` took: a .raw dump in the camera's format, or a picture (BGR).
///
/// @throws std::runtime_error naming the file, what was found and what was expected: it cannot be
///         read, or has another size than the camera
[[nodiscard]] ImageFile read_image(const std::filesystem::path& path,
                                   const vision::CameraParameters& camera);

/// Reads a picture of any size as luminance.
///
/// @throws std::runtime_error if it cannot be read
[[nodiscard]] ImageFile read_grey_picture(const std::filesystem::path& path);

}  // namespace teamsight::tools
