// monitor/order.hpp: what the operator asks for, as checked values.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "bus/messages.hpp"
#include "geometry/result.hpp"
#include "monitor/referee/box_protocol.hpp"

namespace teamsight::monitor {

/// Something for the robots; its id is still to be given.
struct RobotOrder {
  bus::Command command;
  std::string text;  ///< for the log and the page, e.g. "relocate robot 3"

  friend bool operator==(const RobotOrder&, const RobotOrder&) = default;
};

enum class Side : std::uint8_t { kBoth, kOurs, kTheirs };

/// A command of the referee box, given by hand.
struct RefereeOrder {
  std::string command;
  Side side{Side::kBoth};

  friend bool operator==(const RefereeOrder&, const RefereeOrder&) = default;
};

/// A moment to come back to.
struct BookmarkOrder {
  std::string text;

  friend bool operator==(const BookmarkOrder&, const BookmarkOrder&) = default;
};

/// A look at the world without one robot.
struct WithoutOrder {
  RobotId robot{kNobody};
  Duration duration{0};

  friend bool operator==(const WithoutOrder&, const WithoutOrder&) = default;
};

using Order = std::variant<RobotOrder, RefereeOrder, BookmarkOrder, WithoutOrder>;

/// Longest message that a page may send; bytes.
inline constexpr std::size_t kLongestRequest = 1024;

/// An order from the bytes of a MonitorRequest, which may be anything.
///
/// @param token  the station's; without it nothing is taken
/// @return the order, fit to be sent; else what is wrong, for the page
[[nodiscard]] Result<Order, std::string> parse_order(std::string_view bytes,
                                                     std::string_view token);

}  // namespace teamsight::monitor
