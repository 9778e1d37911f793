// process/elsewhere.cpp: see elsewhere.hpp.
#include "process/elsewhere.hpp"

#include <utility>

namespace teamsight::process {

std::set<bus::AnnouncedDomain> without_own(std::set<bus::AnnouncedDomain> heard,
                                           const settings::TeamSettings& team,
                                           const DomainOptions& options) {
  const bus::DomainSettings own = team_domain(team, options);
  const std::uint32_t inside = host_domain(team, options, "").domain_id;
  std::erase_if(heard, [&](const bus::AnnouncedDomain& domain) {
    return (domain.id == own.domain_id && domain.tag == own.tag) ||
           (domain.id == inside && domain.tag.starts_with(team.name + ".")) ||
           (domain.id == inside && !domain.tag.empty() && domain.tag == options.host_tag);
  });
  return heard;
}

Elsewhere::Elsewhere(const settings::TeamSettings& team, const DomainOptions& options)
    : team_(team),
      options_(options) {}

std::string Elsewhere::others(bool hears_somebody, HostTime now) {
  if (hears_somebody) {
    ear_.reset();
    return {};
  }
  if (!ear_) ear_.emplace();
  return bus::to_text(without_own(ear_->heard(now), team_, options_));
}

}  // namespace teamsight::process
