// bus/profile.hpp: reading a DDS profile so strictly that nothing falls back to defaults.
#pragma once

#include <string>
#include <string_view>

#include "geometry/time.hpp"

namespace teamsight::bus {

/// What a profile file says.
struct Profile {
  std::string
      text;  ///< for the library: comments blanked, the tag appended as a fragment of its own
  std::string card;   ///< the network card that it names; empty: the library chooses
  Duration lease{0};  ///< of this network's leased topics; kDefaultLease if the file names none
};

/// Reads a profile.
///
/// The library itself would take an empty text, or a section for another domain, for "all
/// defaults", and a text that is not XML for a file name; these are errors here.
///
/// @param path  a Cyclone DDS XML file whose only root is CycloneDDS, for `any` domain; the lease
///              stands in it as <?teamsight lease_ms="500"?>
/// @param tag   letters, digits, '_', '-' and '.', at most 64; empty = none
/// @throws BusError that names the file, what was found and what was expected
[[nodiscard]] Profile load_profile(const std::string& path, std::string_view tag);

}  // namespace teamsight::bus
