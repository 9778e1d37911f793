// bus/profile.hpp: reading a DDS profile so strictly that nothing falls back to defaults.
#pragma once

#include <string>
#include <string_view>

namespace teamsight::bus {

/// The text of a profile, its comments blanked, with the tag appended as a fragment of its own.
///
/// The library itself would take an empty text, or a section for another domain, for "all
/// defaults", and a text that is not XML for a file name; these are errors here.
///
/// @param path  a Cyclone DDS XML file whose only root is CycloneDDS, for `any` domain
/// @param tag   letters, digits, '_', '-' and '.', at most 64; empty = none
/// @throws BusError that names the file, what was found and what was expected
[[nodiscard]] std::string load_profile(const std::string& path, std::string_view tag);

}  // namespace teamsight::bus
