// bus/other_versions.hpp: who in the domain speaks another version of the topics.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "bus/participant.hpp"

namespace teamsight::bus {

/// The version that this build speaks, as it stands in topic names.
inline constexpr const char* kWireVersion = "v1";

/// Versions never hear one another: their topics have other names. This tells that they are there,
/// from what DDS discovers of all writers anyway. Use from one thread.
class OtherVersions {
 public:
  /// @param participant  outlives this
  explicit OtherVersions(const Participant& participant);
  ~OtherVersions();
  OtherVersions(const OtherVersions&) = delete;
  OtherVersions& operator=(const OtherVersions&) = delete;

  /// The versions that are written in this domain now, e.g. "v2", without our own. Once a second is
  /// often enough.
  [[nodiscard]] std::set<std::string> present() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The version in a topic's name, "v2" of "teamsight/v2/RobotState"; empty: it is not one of ours.
[[nodiscard]] std::string version_of(const std::string& topic);

}  // namespace teamsight::bus
