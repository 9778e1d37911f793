// recording/bus_recorder.cpp: see recording/bus_recorder.hpp.
#include "recording/bus_recorder.hpp"

#include <optional>
#include <type_traits>

#include "bus/clock.hpp"
#include "bus/reader.hpp"
#include "recording/scene.hpp"
#include "recording/stamps.hpp"
#include "recording/topic_channel.hpp"

namespace teamsight::recording {
namespace {

/// One topic, from the bus to the sink.
template <class Message>
class Feed {
 public:
  /// @param scenes  nothing: the topic is no part of any scene
  Feed(const bus::Participant& participant,
       bus::Loop& loop,
       MessageSink& sink,
       SceneChannels* scenes = nullptr)
      : reader_(participant),
        loop_(&loop),
        sink_(&sink),
        scenes_(scenes),
        channel_(sink.add_channel(channel_of<Message>())) {
    loop.on_readable(reader_.event_fd(), [this]() { pass_on(); });
  }

  ~Feed() { loop_->forget(reader_.event_fd()); }

  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;

 private:
  void pass_on() {
    reader_.take(bus::host_now(), [this](const bus::Sample<Message>& sample) {
      if (!sample.message) return;
      const Message& message = *sample.message;
      if (sink_->is_wanted(channel_)) {
        sink_->write(channel_, sample.received, written_at(message), payload_of(message));
      }
      if constexpr (std::is_same_v<Message, WorldModel>) {
        scenes_->write(message, sample.received);
      }
    });
  }

  bus::Reader<Message> reader_;
  bus::Loop* loop_;
  MessageSink* sink_;
  SceneChannels* scenes_;
  ChannelId channel_;
};

}  // namespace

struct BusRecorder::Impl {
  Impl(const bus::Participant& team, bus::Loop& wanted_loop, MessageSink& wanted_sink)
      : loop(wanted_loop),
        sink(wanted_sink),
        scenes(sink),
        states(team, loop, sink),
        sightings(team, loop, sink),
        worlds(team, loop, sink, &scenes),
        explanations(team, loop, sink),
        probes(team, loop, sink),
        echoes(team, loop, sink),
        games(team, loop, sink),
        commands(team, loop, sink),
        diagnostics(team, loop, sink),
        line_points(team, loop, sink),
        thumbnails(team, loop, sink),
        sensors(team, loop, sink) {}

  bus::Loop& loop;
  MessageSink& sink;
  SceneChannels scenes;
  Feed<bus::RobotState> states;
  Feed<bus::Sightings> sightings;
  Feed<WorldModel> worlds;
  Feed<bus::Explanation> explanations;
  Feed<bus::ClockProbe> probes;
  Feed<bus::ClockEcho> echoes;
  Feed<bus::GameState> games;
  Feed<bus::Command> commands;
  Feed<bus::Diagnostics> diagnostics;
  Feed<bus::LinePoints> line_points;
  Feed<bus::Thumbnail> thumbnails;
  Feed<bus::VirtualSensors> sensors;
  std::optional<Feed<bus::Truth>> truths;
};

BusRecorder::BusRecorder(const bus::Participant& team, bus::Loop& loop, MessageSink& sink)
    : impl_(std::make_unique<Impl>(team, loop, sink)) {}

BusRecorder::~BusRecorder() = default;

void BusRecorder::add_truth(const bus::Participant& match) {
  impl_->truths.emplace(match, impl_->loop, impl_->sink);
}

void BusRecorder::draw(const FieldModel& field, HostTime now) {
  impl_->scenes.write(field, now);
}

}  // namespace teamsight::recording
