// settings/calibration_record.hpp: how well a camera is known, in its file.
#pragma once

#include "config.pb.h"
#include "settings/text_format.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::settings {

/// @throws SettingsError if a knob is unknown, named twice or belongs to another kind of mirror, or
///         the correlations are not those of any numbers
[[nodiscard]] vision::CalibrationRecord calibration_record(const TextFile& text,
                                                           const config::CameraFile& file);

void write_record(const vision::CalibrationRecord& record, config::CameraFile::Calibration& out);

}  // namespace teamsight::settings
