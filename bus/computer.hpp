// bus/computer.hpp: on which computer a writer's process runs, as its participant announces it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace teamsight::bus {

/// A computer of the network. The name alone does not tell: robots may be copies of one disk.
struct Computer {
  std::string name;
  std::string address;  ///< of its network card; empty: not known
  bool is_this{false};  ///< the one that asks

  friend bool operator==(const Computer&, const Computer&) = default;
};

/// "omni2 (192.168.1.12)", "this computer" or, where nothing is announced, "another computer".
[[nodiscard]] std::string to_text(const Computer& computer);

/// What a participant's "__NetworkAddresses" says:
/// "udp/239.255.0.1:7400@2,udp/192.168.1.12:7410@2".
///
/// @return the first address that is no multicast one; "" if there is none
[[nodiscard]] std::string unicast_address_in(const std::string& locators);

/// This computer's network cards that are up with an address, loopback left out: "eth0
/// (192.168.1.5)".
///
/// @return nothing if that cannot be asked
[[nodiscard]] std::optional<std::vector<std::string>> cards_up();

/// Whether a network card of this computer has that address, or it is loopback's.
[[nodiscard]] bool is_own_address(const std::string& address);

}  // namespace teamsight::bus
