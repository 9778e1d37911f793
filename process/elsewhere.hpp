// process/elsewhere.hpp: who is there although a team hears nobody.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "bus/other_domains.hpp"
#include "process/domains.hpp"

namespace teamsight::process {

/// Those of the domains that are not a team's: not its own one, not those inside its computers.
[[nodiscard]] std::set<bus::AnnouncedDomain> without_own(std::set<bus::AnnouncedDomain> heard,
                                                         const settings::TeamSettings& team,
                                                         const DomainOptions& options);

/// Listens to other domains for as long as a process hears nobody in its own.
class Elsewhere {
 public:
  Elsewhere(const settings::TeamSettings& team, const DomainOptions& options);

  /// @param hears_somebody  in the own domain; then nothing is listened to
  /// @param now             of the host's clock
  /// @return e.g. "domain 22 (blue)"; empty: nobody, or not listened
  [[nodiscard]] std::string others(bool hears_somebody, HostTime now);

 private:
  settings::TeamSettings team_;
  DomainOptions options_;
  std::optional<bus::OtherDomains> ear_;
};

}  // namespace teamsight::process
