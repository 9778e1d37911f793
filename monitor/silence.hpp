// monitor/silence.hpp: why nothing shows, in words.
#pragma once

#include <string>

#include "geometry/time.hpp"
#include "monitor/update.hpp"

namespace teamsight::monitor {

/// Ends the sentence that somebody speaks another version of the topics.
inline constexpr const char* kNotHeardHere =
    " of the topics, which this station does not hear: install the same packages everywhere";

/// What the station knows beside its own domain's samples.
struct Surroundings {
  std::string where;  ///< it listens, e.g. "domain 7 of team \"a\""
  Duration world_late_after{0};
  std::string other_versions;  ///< spoken in this domain, e.g. "v2"; empty: none
  std::string other_domains;   ///< announced on this network, e.g. "domain 20 (blue)"; empty: none
};

/// @return empty: a fresh world shows
[[nodiscard]] std::string silence_of(const Update& update, const Surroundings& around);

}  // namespace teamsight::monitor
