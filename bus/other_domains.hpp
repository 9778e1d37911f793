// bus/other_domains.hpp: who announces himself on this network in another domain.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "geometry/time.hpp"

namespace teamsight::bus {

/// A domain as its participants announce it.
struct AnnouncedDomain {
  std::uint32_t id{0};
  std::string tag;  ///< empty: none

  friend auto operator<=>(const AnnouncedDomain&, const AnnouncedDomain&) = default;  // NOLINT
};

/// What an RTPS packet announces (RTPS 2.3, 8.5.3: the data of a participant).
///
/// @return the domain's tag, empty if there is none; nothing if the packet is no whole
/// announcement,
///         or what it names can be no tag (over 64 letters, or not printable)
[[nodiscard]] std::optional<std::string> announced_tag(std::span<const std::uint8_t> packet);

/// Listens where the participants of every domain announce themselves by multicast, on each network
/// card that is up. Domains never hear one another, so that DDS cannot tell; this says to whom
/// nobody answers that the others are there, in another domain or under another team's name.
///
/// Holds one socket for each domain: for a station that hears nothing, not for all the game.
/// Nobody is heard who announces himself to named peers only (config/dds/unicast.xml). Use from one
/// thread.
class OtherDomains {
 public:
  OtherDomains();
  ~OtherDomains();
  OtherDomains(const OtherDomains&) = delete;
  OtherDomains& operator=(const OtherDomains&) = delete;

  /// Reads what has come since, without waiting.
  ///
  /// @param now  of the host's clock
  /// @return who was heard within the last 5 s, the own domain among them
  [[nodiscard]] std::set<AnnouncedDomain> heard(HostTime now);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// "domain 20 (blue), domain 22"; at most four, then how many more.
[[nodiscard]] std::string to_text(const std::set<AnnouncedDomain>& domains);

}  // namespace teamsight::bus
