// process/temperature.hpp: how hot the computer is.
#pragma once

#include <filesystem>
#include <optional>

namespace teamsight::process {

/// The hottest of the kernel's thermal zones, degrees Celsius.
///
/// @param folder  where the zones are
/// @return nothing where the computer has none, as a virtual one; a zone that cannot be read, or
///         tells less than 0 or more than 150, is left out
[[nodiscard]] std::optional<double> hottest_zone(
    const std::filesystem::path& folder = "/sys/class/thermal");

}  // namespace teamsight::process
