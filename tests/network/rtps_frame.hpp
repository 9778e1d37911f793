// tests/network/rtps_frame.hpp: whose bytes an Ethernet frame carries, as far as RTPS tells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "tests/network/switch.hpp"

namespace teamsight::network {

/// Adds the frame's bytes to the writers whose submessages (data, fragment, heartbeat, gap, and
/// acknowledgements to them) are in it, in equal parts; to all zeros if there is none or the frame
/// is no RTPS.
void share_out(const std::uint8_t* frame,
               std::size_t size,
               std::map<WriterGuid, std::uint64_t>& bytes);

}  // namespace teamsight::network
