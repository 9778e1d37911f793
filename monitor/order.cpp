// monitor/order.cpp: see monitor/order.hpp.
#include "monitor/order.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdio>

#include <google/protobuf/stubs/logging.h>

#include "bus/fault.hpp"
#include "monitor.pb.h"
#include "monitor/secret.hpp"

namespace teamsight::monitor {
namespace {

using Request = v1::MonitorRequest;
using Parsed = Result<Order, std::string>;

constexpr double kLongestLookMs = 600'000.0;
constexpr std::size_t kLongestText = 80;

// An operator's finger: half a metre, and about a quarter turn of doubt.
const Eigen::Matrix3d kByHand = Eigen::Vector3d(0.25, 0.25, 0.3).asDiagonal();

Parsed refuse(const char* why) {
  return tl::unexpected(std::string(why));
}

std::string robot_name(std::uint32_t robot) {
  return robot == kNobody ? "all robots" : "robot " + std::to_string(robot);
}

/// Checks what the bus would refuse; the id is not given yet, so that any stands in for it.
Parsed robot_order(bus::Command command, std::uint32_t target, std::string text) {
  if (target > kMaxRobotId) return refuse("there is no such robot");
  command.target = static_cast<RobotId>(target);
  command.id = {kNobody, 1, 1};
  command.command = 1;
  if (bus::fault_of(command)) return refuse("a number that cannot be");
  return Order{RobotOrder{command, std::move(text)}};
}

bool is_angle(double angle) {
  return std::abs(angle) <= 7.0;
}

Parsed relocate(const Request::Relocate& order) {
  if (!is_angle(order.theta_rad())) return refuse("a number that cannot be");
  bus::Command command;
  command.kind = bus::CommandKind::kRelocate;
  command.X_FR = {order.x_m(), order.y_m(), order.theta_rad()};
  command.cov = kByHand;
  if (order.robot_id() == kNobody) return refuse("relocate: which robot?");
  return robot_order(command, order.robot_id(), "relocate " + robot_name(order.robot_id()));
}

Parsed mute(const Request::Mute& order) {
  bus::Command command;
  command.kind = order.muted() ? bus::CommandKind::kMute : bus::CommandKind::kUnmute;
  return robot_order(command,
                     order.robot_id(),
                     (order.muted() ? "mute " : "unmute ") + robot_name(order.robot_id()));
}

Parsed ball_hint(const Request::BallHint& order) {
  bus::Command command;
  command.kind = bus::CommandKind::kBallHint;
  command.X_FR = {order.x_m(), order.y_m(), 0.0};
  command.cov = kByHand;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "ball hint %.1f, %.1f m", order.x_m(), order.y_m());
  return robot_order(command, kNobody, text.data());
}

bool is_look_time(double duration_ms) {
  return duration_ms > 0.0 && duration_ms <= kLongestLookMs;
}

Parsed without(const Request::Look& order) {
  if (!is_look_time(order.duration_ms())) return refuse("for how long?");
  if (order.robot_id() == kNobody || order.robot_id() > kMaxRobotId) {
    return refuse("there is no such robot");
  }
  return Order{WithoutOrder{static_cast<RobotId>(order.robot_id()),
                            from_seconds(order.duration_ms() / 1e3)}};
}

Parsed look(bus::CommandKind kind, const Request::Look& order) {
  const double duration_ms = order.duration_ms();
  if (!is_look_time(duration_ms)) return refuse("for how long?");
  bus::Command command;
  command.kind = kind;
  command.duration = from_seconds(duration_ms / 1e3);
  const char* what = kind == bus::CommandKind::kThumbnail ? "picture of " : "line points of ";
  return robot_order(command, order.robot_id(), what + robot_name(order.robot_id()));
}

Parsed referee(const Request::Referee& order) {
  const std::string& name = order.command();
  const bool is_word = !name.empty() && name.size() <= kLongestText &&
                       std::ranges::all_of(name, [](unsigned char letter) {
                         return std::isupper(letter) != 0 || letter == '_';
                       });
  if (!is_word || order.side() > static_cast<std::uint32_t>(Side::kTheirs)) {
    return refuse("no referee's command");
  }
  return Order{RefereeOrder{name, static_cast<Side>(order.side())}};
}

Parsed bookmark(const Request::Bookmark& order) {
  const bool is_text =
      order.text().size() <= kLongestText &&
      std::ranges::none_of(order.text(), [](unsigned char letter) { return letter < 0x20; });
  if (!is_text) return refuse("bookmark: at most 80 characters");
  return Order{BookmarkOrder{order.text()}};
}

}  // namespace

Result<Order, std::string> parse_order(std::string_view bytes, std::string_view token) {
  Request request;
  const google::protobuf::LogSilencer quiet;  // it would print a line for each bad message
  if (bytes.size() > kLongestRequest ||
      !request.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    return refuse("not understood");
  }
  if (token.empty() || !is_same_secret(request.token(), token)) return refuse("wrong token");
  switch (request.order_case()) {
    case Request::kRelocate:
      return relocate(request.relocate());
    case Request::kMute:
      return mute(request.mute());
    case Request::kBallHint:
      return ball_hint(request.ball_hint());
    case Request::kLinePoints:
      return look(bus::CommandKind::kLinePoints, request.line_points());
    case Request::kThumbnail:
      return look(bus::CommandKind::kThumbnail, request.thumbnail());
    case Request::kReferee:
      return referee(request.referee());
    case Request::kBookmark:
      return bookmark(request.bookmark());
    case Request::kWithout:
      return without(request.without());
    case Request::ORDER_NOT_SET:
      break;
  }
  return refuse("no order");
}

}  // namespace teamsight::monitor
