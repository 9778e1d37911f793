// process/domains.hpp: which DDS domains a team's processes join.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bus/participant.hpp"
#include "geometry/identity.hpp"
#include "settings/load.hpp"

namespace teamsight::process {

/// What the command line says about the domains; the same options in every process.
struct DomainOptions {
  std::optional<std::uint32_t> team_domain;  ///< --team-domain: instead of the team file's id
  std::string host_tag;                      ///< --host-tag: empty = default_host_tag
};

/// Tells the robots on one computer apart: "<team>.robot<id>"; the bus takes letters, digits, "_",
/// "-" and ".".
[[nodiscard]] std::string default_host_tag(const settings::TeamSettings& team, RobotId robot);

/// The domain between the robots; tagged with the team's name, so that teams never meet.
///
/// @param speaker  in whose name the process speaks: a robot, or kNobody for the coach station
[[nodiscard]] bus::DomainSettings team_domain(const settings::TeamSettings& team,
                                              const DomainOptions& options,
                                              RobotId speaker = kNobody);

/// The domain inside one robot's computer: the team's id plus one, tagged.
///
/// @param tag  default_host_tag, or what --host-tag says
[[nodiscard]] bus::DomainSettings host_domain(const settings::TeamSettings& team,
                                              const DomainOptions& options,
                                              const std::string& tag);

}  // namespace teamsight::process
