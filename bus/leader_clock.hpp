// bus/leader_clock.hpp: the leading fusion's time, for those who fuse along from outside.
#pragma once

#include <optional>

#include "bus/messages.hpp"
#include "bus/reader.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::bus {

/// What the leading fusion's clock says, and the robots' stamps on it.
///
/// Its offset from this host's comes with each WorldModel, the robots' clocks come with its
/// Explanation; a robot that is not in there is taken to have the leader's clock where its stamps
/// allow that.
class LeaderClock {
 public:
  void hear(const Sample<WorldModel>& sample);
  void hear(const Sample<Explanation>& sample);

  /// Whether a fusion has led yet; until then its time is taken to be this host's.
  [[nodiscard]] bool is_known() const { return is_known_; }

  [[nodiscard]] HostTime at(HostTime host) const { return host + leader_minus_host_; }

  struct Moment {
    HostTime time;
    Duration sigma{0};
  };

  /// A robot's stamp in the leader's time.
  ///
  /// @param now  the present, in the leader's time
  /// @return nothing: that robot's clock is not known
  [[nodiscard]] std::optional<Moment> moment_of(RobotId robot, PeerTime stamp, HostTime now) const;

 private:
  bool is_known_{false};
  Duration leader_minus_host_{0};
  std::optional<Explanation> clocks_;
};

}  // namespace teamsight::bus
