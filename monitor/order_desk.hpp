// monitor/order_desk.hpp: orders to the robots, repeated until they are acknowledged.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bus/messages.hpp"
#include "geometry/time.hpp"
#include "monitor/order.hpp"
#include "monitor/update.hpp"

namespace teamsight::monitor {

/// Follows every order until its robots acknowledge it, a ball hint until the leading fusion does,
/// or for three seconds. A value; no clock.
class OrderDesk {
 public:
  /// @param boot  of this start of the station; orders are numbered from a number made of it, so
  /// that
  ///              a robot that has seen an earlier station does not take an old number for ours
  explicit OrderDesk(std::uint32_t boot);

  /// @param alive  the robots that an order to all has to reach
  /// @return the command to write now
  bus::Command take(const RobotOrder& order, const std::vector<RobotId>& alive, HostTime now);

  /// A robot says what it has carried out.
  void hear(RobotId robot, std::uint32_t acknowledged);

  /// The leading fusion says which ball hint it has taken.
  void hear(const bus::ExplainedHint& hint);

  /// The commands to write again: those not acknowledged yet.
  [[nodiscard]] std::vector<bus::Command> due(HostTime now);

  /// The robots among these that have let an order wait for long, while it is still repeated.
  [[nodiscard]] std::vector<RobotId> unanswered_by(const std::vector<RobotId>& alive,
                                                   HostTime now) const;

  /// For the page; orders leave ten seconds after they were given.
  [[nodiscard]] std::vector<ActionReport> report(HostTime now);

 private:
  struct Pending {
    bus::Command command;
    std::string text;
    HostTime given;
    HostTime written;
    std::set<RobotId> waits_for;  ///< kNobody: the leading fusion
  };

  /// What the newer one is about is not asked again of those whom it reaches.
  void replace_by(const bus::Command& newer);

  std::uint32_t boot_;
  std::uint32_t next_command_;
  std::uint32_t sequence_{0};
  std::vector<Pending> pending_;
};

}  // namespace teamsight::monitor
