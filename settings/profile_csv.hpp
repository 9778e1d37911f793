// settings/profile_csv.hpp: a mirror's meridian as a CSV file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "settings/settings_error.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::settings {

/// Reads `x_m,y_m` rows; further columns (the slope, for one) are left alone.
///
/// @return at least three points, x from the axis outwards and growing
/// @throws SettingsError with the number of the line
[[nodiscard]] std::vector<vision::ProfilePoint> read_profile(const std::filesystem::path& path);

/// The text that read_profile reads back to the same numbers.
[[nodiscard]] std::string profile_csv(const std::vector<vision::ProfilePoint>& profile);

}  // namespace teamsight::settings
