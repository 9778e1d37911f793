// monitor/operator.cpp: see monitor/operator.hpp.
#include "monitor/operator.hpp"

#include <variant>

#include "bus/clock.hpp"
#include "monitor.pb.h"
#include "monitor/order.hpp"

namespace teamsight::monitor {

void Operator::listen(const std::string& token) {
  for (const ClientMessage& message : parts_.server.take_messages()) {
    const auto order = parse_order(message.bytes, token);
    const std::string refusal =
        order ? std::visit([this](const auto& one) { return carry_out(one); }, *order)
              : order.error();
    if (refusal.empty()) continue;
    v1::MonitorUpdate answer;
    answer.set_refused(refusal);
    parts_.server.tell(message.client, answer.SerializeAsString());
  }
}

void Operator::repeat() {
  for (const bus::Command& command : parts_.desk.due(bus::host_now()))
    parts_.commands.write(command);
}

std::string Operator::carry_out(const RobotOrder& order) {
  const HostTime now = bus::host_now();
  parts_.commands.write(parts_.desk.take(order, parts_.station.alive(), now));
  // A picture is asked for again and again; that is no event.
  const bool is_look = order.command.kind == bus::CommandKind::kThumbnail ||
                       order.command.kind == bus::CommandKind::kLinePoints;
  if (!is_look) parts_.station.note(now, Level::kInfo, "Operator: " + order.text);
  return {};
}

std::string Operator::carry_out(const RefereeOrder& order) {
  return parts_.referee.by_hand(order);
}

std::string Operator::carry_out(const BookmarkOrder& order) {
  const std::string text = order.text.empty() ? "Bookmark" : "Bookmark: " + order.text;
  parts_.station.note(bus::host_now(), Level::kInfo, text);
  return {};
}

std::string Operator::carry_out(const WithoutOrder& order) {
  parts_.what_if.ask(order.robot, bus::host_now() + order.duration);
  return {};
}

}  // namespace teamsight::monitor
