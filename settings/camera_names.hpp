// settings/camera_names.hpp: the enumerations of a camera file beside those of vision/.
#pragma once

#include <optional>

#include "config.pb.h"
#include "vision/camera_parameters.hpp"

namespace teamsight::settings {

[[nodiscard]] vision::PixelFormat format_of(config::CameraFile::PixelFormat format);
[[nodiscard]] config::CameraFile::PixelFormat file_format_of(vision::PixelFormat format);

[[nodiscard]] vision::ColourClass class_of(config::CameraFile::Colours::Class colour);

/// @return nothing for kNone, which no file names
[[nodiscard]] std::optional<config::CameraFile::Colours::Class> file_class_of(
    vision::ColourClass colour);

[[nodiscard]] vision::ColourMethod method_of(config::CameraFile::Colours::Method method);
[[nodiscard]] config::CameraFile::Colours::Method file_method_of(vision::ColourMethod method);

[[nodiscard]] vision::SensorKind kind_of(config::CameraFile::Sensor::Kind kind);
[[nodiscard]] config::CameraFile::Sensor::Kind file_kind_of(vision::SensorKind kind);

}  // namespace teamsight::settings
