// monitor/what_if.hpp: the world as it would be without one robot. No clock, no network.
#pragma once

#include <optional>

#include "bus/leader_clock.hpp"
#include "bus/messages.hpp"
#include "bus/reader.hpp"
#include "fusion/fusion.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"
#include "monitor/update.hpp"

namespace teamsight::monitor {

/// A fusion of the station's own that leaves one robot's observations out, while somebody asks.
///
/// It begins with what comes after it was asked, so trust in robots takes some seconds to grow. It
/// works in the leading fusion's time (bus/leader_clock.hpp).
class WhatIf {
 public:
  WhatIf(const fusion::Parameters& parameters, const FieldModel& field);

  /// Leaves `robot` out until `until`. Another robot than before begins anew.
  void ask(RobotId robot, HostTime until);

  void hear(const bus::Sample<bus::Sightings>& sample);
  void hear(const bus::Sample<bus::Explanation>& sample);
  void hear(const bus::Sample<WorldModel>& sample);

  /// @return nothing while nobody asks or no fusion leads
  [[nodiscard]] std::optional<WorldWithout> at(HostTime now);

 private:
  fusion::Fusion fresh_;
  std::optional<fusion::Fusion> fusion_;  ///< nothing: nobody asks
  RobotId robot_{kNobody};
  HostTime until_;
  bus::LeaderClock clock_;
  HostTime newest_;  ///< the leader's time never goes back
};

}  // namespace teamsight::monitor
