// monitor/order_desk.cpp: see monitor/order_desk.hpp.
#include "monitor/order_desk.hpp"

#include <algorithm>
#include <chrono>

namespace teamsight::monitor {
namespace {

constexpr Duration kPatience = std::chrono::seconds(3);
constexpr Duration kDoubt = kPatience / 2;  // what is then mended is in time for the last repeats
constexpr Duration kRepeat = std::chrono::milliseconds(300);
constexpr Duration kShown = std::chrono::seconds(10);
constexpr std::size_t kMostPending = 64;

// Mute and unmute are about one thing.
bool are_about_the_same(const bus::Command& a, const bus::Command& b) {
  const auto thing = [](bus::CommandKind kind) {
    return kind == bus::CommandKind::kUnmute ? bus::CommandKind::kMute : kind;
  };
  return thing(a.kind) == thing(b.kind);
}

}  // namespace

// Repeating both would have the robot go to and fro, or end with the older.
void OrderDesk::replace_by(const bus::Command& newer) {
  std::erase_if(pending_, [&](Pending& older) {
    if (older.waits_for.empty() || !are_about_the_same(newer, older.command)) return false;
    if (newer.target == kNobody || newer.target == older.command.target) return true;
    return older.waits_for.erase(newer.target) > 0 && older.waits_for.empty();
  });
}

OrderDesk::OrderDesk(std::uint32_t boot) : boot_(boot), next_command_(boot | 1U) {}

bus::Command OrderDesk::take(const RobotOrder& order,
                             const std::vector<RobotId>& alive,
                             HostTime now) {
  Pending pending;
  pending.command = order.command;
  pending.command.id = {kNobody, boot_, ++sequence_};
  pending.command.command = next_command_;
  next_command_ = next_command_ + 1 == 0 ? 1 : next_command_ + 1;
  pending.text = order.text;
  pending.given = pending.written = now;
  replace_by(order.command);
  if (order.command.kind == bus::CommandKind::kBallHint) {
    pending.waits_for.insert(kNobody);
  } else if (order.command.target == kNobody) {
    pending.waits_for.insert(alive.begin(), alive.end());
  } else {
    pending.waits_for.insert(order.command.target);
  }
  if (pending_.size() == kMostPending) pending_.erase(pending_.begin());
  pending_.push_back(pending);
  return pending.command;
}

void OrderDesk::hear(RobotId robot, std::uint32_t acknowledged) {
  for (Pending& pending : pending_) {
    if (pending.command.command == acknowledged) pending.waits_for.erase(robot);
  }
}

void OrderDesk::hear(const bus::ExplainedHint& hint) {
  if (hint.command != 0) hear(kNobody, hint.command);
}

std::vector<bus::Command> OrderDesk::due(HostTime now) {
  std::vector<bus::Command> commands;
  for (Pending& pending : pending_) {
    const bool waits = !pending.waits_for.empty() && now - pending.given < kPatience;
    if (!waits || now - pending.written < kRepeat) continue;
    pending.written = now;
    // One to all is repeated to each who owes an answer, as the others may have a newer one.
    for (const RobotId robot : pending.waits_for) {
      bus::Command command = pending.command;
      command.id.sequence = ++sequence_;
      if (robot != kNobody) command.target = robot;
      commands.push_back(command);
    }
  }
  return commands;
}

std::vector<RobotId> OrderDesk::unanswered_by(const std::vector<RobotId>& alive,
                                              HostTime now) const {
  std::vector<RobotId> robots;
  for (const RobotId robot : alive) {
    if (std::any_of(pending_.begin(), pending_.end(), [&](const Pending& pending) {
          const Duration age = now - pending.given;
          return age >= kDoubt && age < kPatience && pending.waits_for.contains(robot);
        })) {
      robots.push_back(robot);
    }
  }
  return robots;
}

std::vector<ActionReport> OrderDesk::report(HostTime now) {
  std::erase_if(pending_, [&](const Pending& pending) { return now - pending.given > kShown; });
  std::vector<ActionReport> reports;
  for (const Pending& pending : pending_) {
    ActionReport report;
    report.command = pending.command.command;
    report.text = pending.text;
    report.age = now - pending.given;
    if (pending.waits_for.empty()) {
      report.state = ActionState::kDone;
    } else if (report.age >= kPatience) {
      report.state = ActionState::kNoAnswer;
    }
    reports.push_back(report);
  }
  return reports;
}

}  // namespace teamsight::monitor
