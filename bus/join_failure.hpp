// bus/join_failure.hpp: why a domain could not be joined, for whoever can mend it. For bus/ only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bus/participant.hpp"

namespace teamsight::bus {

struct JoinFailure {
  std::string line;      ///< which file, what was found, what to do
  bool may_pass{false};  ///< a network card is only down
};

/// What the library has just said and returned; to be asked while its log is captured.
[[nodiscard]] JoinFailure failure_of(const DomainSettings& settings,
                                     const char* call,
                                     std::int32_t code);

/// A profile that lets the library choose among the network cards, on a computer where only
/// loopback has an address: the library would take that, and stay there when a card comes up.
///
/// @param configuration  the profile, complete
/// @return nothing if there is a card, or the profile names its own
[[nodiscard]] std::optional<JoinFailure> missing_card(const DomainSettings& settings,
                                                      const std::string& configuration);

}  // namespace teamsight::bus
