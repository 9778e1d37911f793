// fusion/service/clock_book.cpp: see fusion/service/clock_book.hpp.
#include "fusion/service/clock_book.hpp"

#include <algorithm>
#include <chrono>

namespace teamsight::fusion {
namespace {

constexpr std::size_t kMaxReplies = 16;
constexpr Duration kTaken = std::chrono::seconds(3);  // three echoes
constexpr Duration kPlausible = std::chrono::seconds(1);

std::size_t index_of(RobotId robot) {
  return static_cast<std::size_t>(robot) - 1U;
}

bool is_robot(RobotId robot) {
  return robot_bit(robot) != 0;
}

}  // namespace

ClockBook::ClockBook(RobotId host, std::uint32_t boot) : host_(host), boot_(boot) {
  replies_.reserve(kMaxReplies);
}

bus::ClockProbe ClockBook::next_probe(HostTime now) {
  ++probes_;
  questions_[probes_ % questions_.size()] = {probes_, now};
  return {{host_, boot_, probes_}, stamp_of(now)};
}

void ClockBook::take_probe(const bus::ClockProbe& probe, HostTime now) {
  if (probe.id.robot == host_ && probe.id.boot == boot_) return;
  // A newer question of the same asker replaces the older: only one answer is of use.
  std::erase_if(replies_, [&](const bus::ClockReply& reply) {
    return reply.probe.robot == probe.id.robot && reply.probe.boot == probe.id.boot;
  });
  if (replies_.size() < kMaxReplies) replies_.push_back({probe.id, stamp_of(now)});
}

std::optional<bus::ClockEcho> ClockBook::next_echo(HostTime now) {
  if (replies_.empty()) return std::nullopt;
  ++echoes_;
  bus::ClockEcho echo{{host_, boot_, echoes_}, stamp_of(now), replies_};
  replies_.clear();
  return echo;
}

void ClockBook::take_echo(const bus::ClockEcho& echo, HostTime now) {
  if (!is_robot(echo.id.robot) || echo.id.robot == host_) return;
  Peer& peer = peers_[index_of(echo.id.robot)];
  if (peer.boot != echo.id.boot) {
    if (peer.boot != 0 && now - peer.heard < kTaken) return;
    peer.boot = echo.id.boot;
    peer.clock.forget();
  }
  peer.heard = now;
  for (const bus::ClockReply& reply : echo.replies) {
    if (reply.probe.robot != host_ || reply.probe.boot != boot_) continue;
    const Question& question = questions_[reply.probe.sequence % questions_.size()];
    if (question.sequence != reply.probe.sequence) continue;
    peer.clock.add({question.sent, reply.received, echo.sent, now});
  }
}

std::optional<ClockEstimate> ClockBook::estimate(RobotId robot, HostTime now) const {
  if (!is_robot(robot) || robot == host_) return std::nullopt;
  return peers_[index_of(robot)].clock.at(now);
}

std::optional<ConvertedStamp> ClockBook::convert(RobotId robot,
                                                 PeerTime stamp,
                                                 HostTime now) const {
  const HostTime as_ours = to_host_time(stamp, Duration{0});
  if (robot == host_) return ConvertedStamp{as_ours, Duration{0}};
  if (const auto measured = estimate(robot, now)) {
    return ConvertedStamp{to_host_time(stamp, measured->offset), measured->sigma};
  }
  const bool is_plausible = as_ours <= now + kPlausible && as_ours + kPlausible >= now;
  if (!is_plausible) return std::nullopt;
  return ConvertedStamp{as_ours, Duration{0}};
}

}  // namespace teamsight::fusion
