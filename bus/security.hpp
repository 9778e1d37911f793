// bus/security.hpp: DDS Security out of one folder per speaker (`teamsight keys` makes them). For
// bus/ only.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/identity.hpp"

namespace teamsight::bus {

/// Who speaks in a secured domain, by its folder.
struct Identity {
  std::string configuration;  ///< for the library, to be appended to the profile
  std::string partition;      ///< in which it writes: "robot3" or "coach"
};

/// Reads nothing but names: checks that the folder is whole, and that its key is nobody else's.
///
/// @param folder  made by `teamsight keys`, e.g. /etc/teamsight/keys/robot3
/// @throws BusError that names the file, what was found and what was expected
[[nodiscard]] Identity load_identity(const std::string& folder);

/// Whose samples may come in this partition: a robot's id, kNobody for the coach station.
///
/// @return nothing if it is no speaker's partition
[[nodiscard]] std::optional<RobotId> speaker_of(std::string_view partition) noexcept;

}  // namespace teamsight::bus
