// bus/fault.hpp: whether a value may travel at all, without a network.
#pragma once

#include <optional>

#include "bus/reject.hpp"

namespace teamsight::bus {

/// The first rule of its topic that `message` breaks, by the same check as every write and take.
///
/// Defined for every message of bus/messages.hpp and for WorldModel.
///
/// @return nothing if all is well
template <class Message>
[[nodiscard]] std::optional<Reject> fault_of(const Message& message);

}  // namespace teamsight::bus
