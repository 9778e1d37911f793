// settings/mirror_file.hpp: a mirror's design file as parameters.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "settings/settings_error.hpp"
#include "vision/mirror/design.hpp"

namespace teamsight::settings {

/// A mirror file (config/mirrors).
struct MirrorSettings {
  mirror::MirrorParameters parameters;
  std::optional<double> pixel_pitch;  ///< of the sensor; m; nothing if the file does not say
};

/// Reads a mirror file and, if it names one, the profile beside it.
///
/// Whether the design closes is not asked here: see mirror::design.
///
/// @throws SettingsError if the file or the profile cannot be used
[[nodiscard]] MirrorSettings load_mirror(const std::filesystem::path& path);

/// Reads a profile of `x_m,y_m,slope` rows that ends where its last row is.
///
/// Two rows 1 nm apart are a joint at which the tangent may jump.
///
/// @return at least one part; parts are named after the file
/// @throws SettingsError if a row is no three numbers, or x does not grow (the profile is then not
/// a
///         function)
[[nodiscard]] mirror::Profile read_mirror_profile(const std::filesystem::path& path);

/// The text that read_mirror_profile reads back: `x_m,y_m,slope`, full precision. At a joint the
/// outer part's first row lies 1 nm further out if the slope jumps and is left out if it does not.
[[nodiscard]] std::string mirror_profile_csv(const mirror::Profile& profile);

}  // namespace teamsight::settings
