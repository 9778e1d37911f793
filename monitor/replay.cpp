// monitor/replay.cpp: see monitor/replay.hpp.
#include "monitor/replay.hpp"

#include <array>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "bus/topics.hpp"
#include "monitor.pb.h"
#include "monitor/recording_feed.hpp"
#include "monitor/update_to_proto.hpp"
#include "recording/from_proto.hpp"
#include "recording/mcap_reader.hpp"

namespace teamsight::monitor {
namespace {

/// Who a sample's writer is, where readers tell instances apart.
template <class Message>
std::uint64_t instance_of(const Message& message) {
  return message.id.robot;
}

/// What the referee said, told from what it changed; empty: nothing that is told.
std::string change_of(const bus::GameState& before, const bus::GameState& now) {
  constexpr std::array kPieces{"",
                               "kick-off",
                               "free kick",
                               "goal kick",
                               "throw-in",
                               "corner",
                               "penalty",
                               "drop ball",
                               "park"};
  constexpr std::array kPhases{
      "", "before the game", "first half", "half time", "second half", "over", "shoot-out"};
  if (now.goals_own > before.goals_own) return "goal for us";
  if (now.goals_opponent > before.goals_opponent) return "goal for them";
  if (now.phase != before.phase) return kPhases.at(static_cast<std::size_t>(now.phase));
  const bool is_new = now.piece != before.piece || now.piece_is_ours != before.piece_is_ours;
  if (now.piece != bus::SetPiece::kNone && is_new) {
    const bool has_side = now.piece < bus::SetPiece::kDropball;
    return std::string(!has_side           ? ""
                       : now.piece_is_ours ? "our "
                                           : "their ") +
           kPieces.at(static_cast<std::size_t>(now.piece));
  }
  if (now.running != before.running) return now.running ? "START" : "STOP";
  return {};
}

/// The station that sees a recording go by, and what it showed.
class Projector {
 public:
  Projector(const StationParameters& parameters, bool has_events)
      : station_(parameters),
        has_events_(has_events) {
    feed<bus::RobotState>();
    feed<bus::Sightings>();
    feed<WorldModel>();
    feed<bus::Explanation>();
    feed<bus::Diagnostics>();
    feed<bus::LinePoints>();
    feed<bus::Thumbnail>();
    feed<bus::VirtualSensors>();
    feed<bus::Truth>();
    hears_[std::string(bus::topic_profile<bus::GameState>().topic)] = [this](auto payload,
                                                                             auto at) {
      const auto game = recording::from_payload<bus::GameState>(payload);
      if (game) take_game(*game, at);
      return game.has_value();
    };
    hears_[kEventTopic] = [this](auto payload, auto) {
      return events_.ParseFromString(std::string(payload)) && merge_events();
    };
  }

  /// @return false if nobody would have taken it
  bool hear(const std::string& topic, std::string_view payload, HostTime received) {
    const auto found = hears_.find(topic);
    return found == hears_.end() || found->second(payload, received);
  }

  void show(HostTime now, Replay& replay) {
    Update update = station_.update(now);
    update.referee = game_;
    if (game_) update.referee->state.command_age += now - game_heard_;
    v1::MonitorUpdate message;
    to_proto(update, message);
    thumbnails_to_proto(update, message);
    if (!has_events_) events_to_proto(update, message);
    message.MergeFrom(pending_);
    pending_.Clear();
    const std::string bytes = message.SerializeAsString();
    for (unsigned shift = 0; shift < 32; shift += 8) {
      replay.body.push_back(static_cast<char>((bytes.size() >> shift) & 0xFFU));
    }
    replay.body += bytes;
    ++replay.updates;
  }

 private:
  using Hear = std::function<bool(std::string_view, HostTime)>;

  template <class Message>
  void feed() {
    hears_[std::string(bus::topic_profile<Message>().topic)] = [this](std::string_view payload,
                                                                      HostTime received) {
      bus::Sample<Message> sample;
      sample.message = recording::from_payload<Message>(payload);
      if (!sample.message) return false;
      sample.instance = instance_of(*sample.message);
      sample.received = received;
      station_.hear(sample);
      return true;
    };
  }

  /// What changed in the game is also an event where the station's own are missing.
  void take_game(const bus::GameState& game, HostTime at) {
    const std::string change = change_of(game_ ? game_->state : bus::GameState{}, game);
    if (!change.empty()) {
      station_.note(at, Level::kInfo, "Referee: " + change);
      last_command_ = change;
    }
    game_.emplace();
    game_->state = game;
    game_->last_command = last_command_;
    game_->has_box = game.box_connected;
    game_heard_ = at;
  }

  bool merge_events() {
    pending_.MergeFrom(events_);
    return true;
  }

  Station station_;
  bool has_events_;
  std::optional<RefereeReport> game_;
  HostTime game_heard_;
  std::string last_command_;
  v1::MonitorUpdate events_;
  v1::MonitorUpdate pending_;  ///< recorded events since the last update
  std::map<std::string, Hear, std::less<>> hears_;
};

std::string fact(const recording::Contents& contents, const std::string& name) {
  const auto facts = contents.metadata.find("teamsight.recording");
  if (facts == contents.metadata.end()) return {};
  const auto found = facts->second.find(name);
  return found == facts->second.end() ? std::string() : found->second;
}

bool has_topic(const recording::Contents& contents, const std::string& topic) {
  for (const auto& [id, channel] : contents.channels) {
    if (channel.topic == topic) return true;
  }
  return false;
}

}  // namespace

Replay load_replay(const std::filesystem::path& file, StationParameters parameters) {
  const recording::McapReader reader(file);
  const recording::Contents& contents = reader.contents();
  Replay replay;
  replay.team = fact(contents, "team");
  replay.damage = contents.damage;
  replay.date_minus_stamp =
      Duration{std::strtoll(fact(contents, "log_minus_host_ns").c_str(), nullptr, 10)};
  parameters.is_recording = true;
  Projector projector(parameters, has_topic(contents, kEventTopic));
  const auto host_time = [&](std::int64_t log_ns) {
    return HostTime{Duration{log_ns} - replay.date_minus_stamp};
  };
  HostTime next = host_time(contents.span.from_ns) + kReplayStep;
  reader.for_each({}, [&](const recording::Message& message) {
    const HostTime received = host_time(message.stamp.log_ns);
    // A pause of hours in a file is one update, not thousands.
    if (received - next > std::chrono::seconds(60)) next = received;
    for (; received >= next; next += kReplayStep) projector.show(next, replay);
    if (!projector.hear(message.channel->topic, message.payload, received)) ++replay.skipped;
    return true;
  });
  projector.show(next, replay);
  if (contents.messages == 0) {
    throw recording::RecordingError(file.string() + ": holds no message to show");
  }
  return replay;
}

}  // namespace teamsight::monitor
