// settings/colour_cube_part.hpp: a camera file's colour cube, read and written.
#pragma once

#include "config.pb.h"
#include "settings/text_format.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::settings {

/// @throws SettingsError naming the key, if the planes cut nothing or do not meet in one point, or
///         the vertices make no sense
[[nodiscard]] vision::CubeParameters cube_of(const TextFile& text,
                                             const config::CameraFile::Colours::Cube& file);

void write_cube(const vision::CubeParameters& cube, config::CameraFile::Colours::Cube& out);

}  // namespace teamsight::settings
