// monitor/operator.cpp: see monitor/operator.hpp.
#include "monitor/operator.hpp"

#include <variant>

#include "bus/clock.hpp"
#include "monitor.pb.h"
#include "monitor/order.hpp"

namespace teamsight::monitor {

void Operator::listen(const std::string& token) {
  for (const ClientMessage& message : server_->take_messages()) {
    const auto order = parse_order(message.bytes, token);
    const std::string refusal =
        order ? std::visit([this](const auto& one) { return carry_out(one); }, *order)
              : order.error();
    if (refusal.empty()) continue;
    v1::MonitorUpdate answer;
    answer.set_refused(refusal);
    server_->tell(message.client, answer.SerializeAsString());
  }
}

void Operator::repeat() {
  for (const bus::Command& command : desk_->due(bus::host_now())) commands_->write(command);
}

std::string Operator::carry_out(const RobotOrder& order) {
  const HostTime now = bus::host_now();
  commands_->write(desk_->take(order, station_->alive(), now));
  // A picture is asked for again and again; that is no event.
  const bool is_look = order.command.kind == bus::CommandKind::kThumbnail ||
                       order.command.kind == bus::CommandKind::kLinePoints;
  if (!is_look) station_->note(now, Level::kInfo, "Operator: " + order.text);
  return {};
}

std::string Operator::carry_out(const RefereeOrder& order) {
  return referee_->by_hand(order);
}

std::string Operator::carry_out(const BookmarkOrder& order) {
  station_->note(bus::host_now(), Level::kInfo, "Bookmark: " + order.text);
  return {};
}

}  // namespace teamsight::monitor
