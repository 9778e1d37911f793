// bench/kept_play/kept_game.cpp: see kept_game.hpp.
#include "bench/kept_play/kept_game.hpp"

#include <fstream>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "bench/camera_play/shown.hpp"
#include "bench/play/network.hpp"
#include "bus/messages.hpp"
#include "recording/from_proto.hpp"
#include "recording/mcap_reader.hpp"
#include "recording/mcap_writer.hpp"
#include "recording/topic_channel.hpp"

namespace teamsight::kept_play {
namespace {

constexpr const char* kFacts = "teamsight.kept_game";
constexpr const char* kLooks = "looks";  // how many there are; beside the facts

bus::Sightings sightings_of(const fusion::Observation& look) {
  bus::Sightings sightings;
  sightings.id = look.id;
  sightings.exposure = PeerTime{look.exposure.time_since_epoch()};
  sightings.published = sightings.exposure;
  sightings.posture = look.posture;
  sightings.balls = look.balls;
  sightings.obstacles = look.obstacles;
  return sightings;
}

fusion::Observation look_of(bus::Sightings&& sightings) {
  fusion::Observation look;
  look.id = sightings.id;
  look.exposure = HostTime{sightings.exposure.time_since_epoch()};
  look.posture = sightings.posture;
  look.balls = std::move(sightings.balls);
  look.obstacles = std::move(sightings.obstacles);
  return look;
}

std::string recording_of(const std::string& name, const Facts& facts, const Looks& looks) {
  std::string bytes;
  recording::McapWriter writer(
      [&bytes](std::string_view more) {
        bytes.append(more);
        return true;
      },
      "teamsight kept game");
  const std::uint16_t channel = writer.add_channel(recording::channel_of<bus::Sightings>());
  for (const fusion::Observation& look : looks) {
    const bus::Sightings sightings = sightings_of(look);
    const std::string payload = recording::payload_of(sightings);
    if (recording::from_payload<bus::Sightings>(payload) != sightings) {
      throw std::runtime_error(fmt::format("{}: frame {} of robot {} cannot be kept as it is",
                                           name,
                                           sightings.id.sequence,
                                           sightings.id.robot));
    }
    const std::int64_t ns = sightings.exposure.time_since_epoch().count();
    writer.write(channel, {ns, ns, sightings.id.sequence}, payload);
  }
  Facts written = facts;
  written[kLooks] = std::to_string(looks.size());
  writer.add_metadata(kFacts, written);
  writer.finish();
  return bytes;
}

void check_facts(const std::string& name, const Facts& found, const Facts& expected) {
  for (const auto& [fact, value] : expected) {
    const auto entry = found.find(fact);
    if (entry != found.end() && entry->second == value) continue;
    throw OtherGame(fmt::format("{}: {}: found {}, expected {}",
                                name,
                                fact,
                                entry == found.end() ? "nothing" : entry->second,
                                value));
  }
}

}  // namespace

void write_game(const std::filesystem::path& file, const Facts& facts, const Looks& looks) {
  const std::string bytes = recording_of(file.string(), facts, looks);
  const std::filesystem::path part = file.string() + ".part";
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(part, file, error);
  if (!out || error) throw std::runtime_error(file.string() + ": cannot be written");
}

Looks read_game(const std::filesystem::path& file, const Facts& expected) {
  const std::string name = file.string();
  const recording::McapReader reader(file);
  const recording::Contents& contents = reader.contents();
  const auto facts = contents.metadata.find(kFacts);
  if (!contents.damage.empty() || facts == contents.metadata.end()) {
    throw std::runtime_error(fmt::format("{}: not a whole kept game{}{}",
                                         name,
                                         contents.damage.empty() ? "" : ": ",
                                         contents.damage));
  }
  check_facts(name, facts->second, expected);
  Looks looks;
  reader.for_each({}, [&](const recording::Message& message) {
    auto sightings = recording::from_payload<bus::Sightings>(message.payload);
    if (!sightings) throw std::runtime_error(name + ": a frame in it is no robot's");
    looks.push_back(look_of(*std::move(sightings)));
    return true;
  });
  check_facts(name, facts->second, {{kLooks, std::to_string(looks.size())}});
  return looks;
}

play::Frame KeepingEyes::look(std::size_t robot, const play::Moment& moment, double since) {
  play::Frame frame = eyes_.look(robot, moment, since);
  looks_.push_back(frame.observation);
  looks_.back().exposure = play::host_time(moment.t);
  return frame;
}

play::Frame KeptEyes::look(std::size_t robot, const play::Moment& moment, double /*since*/) {
  const bool is_there = next_ < looks_.size() && looks_[next_].id.robot == robot + 1 &&
                        looks_[next_].exposure == play::host_time(moment.t);
  if (!is_there) {
    throw std::runtime_error(fmt::format(
        "kept game: look {} is not of robot {} at {:.3f} s", next_ + 1, robot + 1, moment.t));
  }
  play::Frame frame;
  frame.observation = std::move(looks_[next_++]);
  frame.observation.exposure = {};
  camera_play::tell_shown(moment, robot, radius_, frame);
  return frame;
}

}  // namespace teamsight::kept_play
