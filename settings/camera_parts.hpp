// settings/camera_parts.hpp: colours, windows and sensors of a camera file, read and written.
#pragma once

#include <string>
#include <vector>

#include "config.pb.h"
#include "settings/text_format.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::settings {

/// @throws SettingsError, as all of these that read do, naming the key
[[nodiscard]] vision::ColourParameters colours_of(const TextFile& text,
                                                  const config::CameraFile::Colours& file);

/// @param key of the polygon in the file
[[nodiscard]] vision::Polygon polygon_of(const TextFile& text,
                                         const std::string& key,
                                         const config::CameraFile::Polygon& file);

[[nodiscard]] std::vector<vision::SensorWindows> sensors_of(const TextFile& text,
                                                            const config::CameraFile& file);

void write_colours(const vision::ColourParameters& colours, config::CameraFile::Colours& out);
void write_polygon(const vision::Polygon& polygon, config::CameraFile::Polygon& out);
void write_sensor(const vision::SensorWindows& sensor, config::CameraFile::Sensor& out);

}  // namespace teamsight::settings
