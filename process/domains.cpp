// process/domains.cpp: see domains.hpp.
#include "process/domains.hpp"

namespace teamsight::process {

std::string default_host_tag(const settings::TeamSettings& team, RobotId robot) {
  return team.name + ".robot" + std::to_string(robot);
}

bus::DomainSettings team_domain(const settings::TeamSettings& team,
                                const DomainOptions& options,
                                RobotId speaker) {
  bus::DomainSettings domain{
      options.team_domain.value_or(team.domain_id), team.dds_profile.string(), team.name};
  if (!team.security.empty()) {
    const std::string name = speaker == kNobody ? "coach" : "robot" + std::to_string(speaker);
    domain.identity = (team.security / name).string();
  }
  return domain;
}

bus::DomainSettings host_domain(const settings::TeamSettings& team,
                                const DomainOptions& options,
                                const std::string& tag) {
  // The library has one configuration per domain id, and the two profiles differ.
  return {options.team_domain.value_or(team.domain_id) + 1, team.host_profile.string(), tag};
}

}  // namespace teamsight::process
