// tools/log_replay.cpp: `teamsight log replay`.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <thread>

#include "bus/clock.hpp"
#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "bus/topics.hpp"
#include "bus/writer.hpp"
#include "process/program.hpp"
#include "recording/from_proto.hpp"
#include "recording/stamps.hpp"
#include "settings/load.hpp"
#include "tools/log_actions.hpp"

namespace teamsight::tools {
namespace {

constexpr Duration kLongestWait = std::chrono::milliseconds(20);

/// From the recording's stamps to the present, at the speed wanted.
///
/// One map for all stamps, so that the offsets between the robots' clocks stay as they were.
struct Present {
  HostTime start;            ///< when the replay began
  std::int64_t first_ns{0};  ///< log time of the first message
  std::int64_t log_minus_host_ns{0};
  double speed{1.0};

  [[nodiscard]] HostTime due(std::int64_t log_ns) const {
    return start + Duration{std::llround(static_cast<double>(log_ns - first_ns) / speed)};
  }

  [[nodiscard]] PeerTime moved(PeerTime stamp) const {
    return stamp_of(due(stamp.time_since_epoch().count() + log_minus_host_ns));
  }
};

/// Writes one topic's recorded messages; false if the payload is not one.
using Put = std::function<bool(std::string_view, const Present&)>;

template <class Message>
void add(const bus::Participant& participant, std::map<std::string, Put, std::less<>>& puts) {
  auto writer = std::make_shared<bus::Writer<Message>>(participant);
  puts[std::string(bus::topic_profile<Message>().topic)] = [writer](std::string_view payload,
                                                                    const Present& present) {
    auto message = recording::from_payload<Message>(payload);
    if (!message) return false;
    recording::for_each_stamp(*message, [&](PeerTime& stamp) { stamp = present.moved(stamp); });
    return writer->write(*message) == bus::WriteStatus::kWritten;
  };
}

/// Only the team's own topics: what stays inside a computer is not put on the air.
std::map<std::string, Put, std::less<>> writers(const bus::Participant& participant) {
  std::map<std::string, Put, std::less<>> puts;
  add<bus::RobotState>(participant, puts);
  add<bus::Sightings>(participant, puts);
  add<WorldModel>(participant, puts);
  add<bus::Explanation>(participant, puts);
  add<bus::ClockProbe>(participant, puts);
  add<bus::ClockEcho>(participant, puts);
  add<bus::GameState>(participant, puts);
  add<bus::Command>(participant, puts);
  add<bus::Diagnostics>(participant, puts);
  add<bus::LinePoints>(participant, puts);
  add<bus::Thumbnail>(participant, puts);
  return puts;
}

/// @return whether the wait was not ended by a stop
bool wait_until(HostTime due, const bus::Loop& loop) {
  for (HostTime now = bus::host_now(); now < due && loop.keeps_running(); now = bus::host_now()) {
    std::this_thread::sleep_for(std::min<Duration>(due - now, kLongestWait));
  }
  return loop.keeps_running();
}

}  // namespace

int log_replay(const LogReplay& request) {
  const recording::McapReader reader(request.in);
  const recording::Contents& contents = reader.contents();
  const settings::TeamSettings team = settings::load_team(request.team);
  bus::Loop loop;
  const auto participant = bus::Participant::join(process::team_domain(team, request.domains),
                                                  [&]() { return loop.keeps_running(); });
  const auto puts = writers(participant);
  const recording::TimeSpan span = span_of(request.selection, contents);
  Present present;
  present.start = bus::host_now() + std::chrono::milliseconds(500);  // until readers have matched
  present.first_ns = std::max(span.from_ns, contents.span.from_ns);
  present.log_minus_host_ns = log_minus_host_of(contents);
  present.speed = request.speed;
  std::uint64_t written = 0;
  std::uint64_t skipped = 0;
  reader.for_each(span, [&](const recording::Message& message) {
    const auto put = puts.find(message.channel->topic);
    if (put == puts.end() || !is_selected(request.selection, message.channel->topic)) return true;
    if (!wait_until(present.due(message.stamp.log_ns), loop)) return false;
    ++(put->second(message.payload, present) ? written : skipped);
    return true;
  });
  std::printf("{\"written\": %llu, \"skipped\": %llu}\n",
              static_cast<unsigned long long>(written),
              static_cast<unsigned long long>(skipped));
  return written > 0 ? process::kDone : process::kAnswerIsNo;
}

}  // namespace teamsight::tools
