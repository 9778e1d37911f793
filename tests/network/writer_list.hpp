// tests/network/writer_list.hpp: which topic every writer on the bus writes.
#pragma once

#include <map>
#include <string>

#include "tests/network/switch.hpp"

namespace teamsight::bus {
class Participant;
}

namespace teamsight::network {

/// Writes a line per writer that this participant knows: its GUID as 32 hex digits, a space, its
/// topic.
void list_writers(const bus::Participant& participant, const std::string& path);

/// Reads such a file; empty if it is not there.
[[nodiscard]] std::map<WriterGuid, std::string> read_writers(const std::string& path);

}  // namespace teamsight::network
