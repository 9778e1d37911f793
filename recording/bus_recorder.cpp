// recording/bus_recorder.cpp: see recording/bus_recorder.hpp.
#include "recording/bus_recorder.hpp"

#include <optional>

#include "bus/clock.hpp"
#include "bus/reader.hpp"
#include "recording/stamps.hpp"
#include "recording/topic_channel.hpp"

namespace teamsight::recording {
namespace {

/// One topic, from the bus to the recorder.
template <class Message>
class Feed {
 public:
  Feed(const bus::Participant& participant, bus::Loop& loop, Recorder& recorder)
      : reader_(participant),
        loop_(&loop),
        recorder_(&recorder) {
    channel_ = recorder.add_channel(channel_of<Message>());
    loop.on_readable(reader_.event_fd(), [this]() { pass_on(); });
  }

  ~Feed() { loop_->forget(reader_.event_fd()); }

  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;

 private:
  void pass_on() {
    reader_.take(bus::host_now(), [this](const bus::Sample<Message>& sample) {
      if (!sample.message) return;
      recorder_->write(
          channel_, sample.received, written_at(*sample.message), payload_of(*sample.message));
    });
  }

  bus::Reader<Message> reader_;
  bus::Loop* loop_;
  Recorder* recorder_;
  ChannelId channel_{0};
};

}  // namespace

struct BusRecorder::Impl {
  Impl(const bus::Participant& team, bus::Loop& wanted_loop, Recorder& wanted_recorder)
      : loop(wanted_loop),
        recorder(wanted_recorder),
        states(team, loop, recorder),
        sightings(team, loop, recorder),
        worlds(team, loop, recorder),
        explanations(team, loop, recorder),
        probes(team, loop, recorder),
        echoes(team, loop, recorder),
        games(team, loop, recorder),
        commands(team, loop, recorder),
        diagnostics(team, loop, recorder),
        line_points(team, loop, recorder),
        thumbnails(team, loop, recorder) {}

  bus::Loop& loop;
  Recorder& recorder;
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
  std::optional<Feed<bus::Truth>> truths;
};

BusRecorder::BusRecorder(const bus::Participant& team, bus::Loop& loop, Recorder& recorder)
    : impl_(std::make_unique<Impl>(team, loop, recorder)) {}

BusRecorder::~BusRecorder() = default;

void BusRecorder::add_truth(const bus::Participant& match) {
  impl_->truths.emplace(match, impl_->loop, impl_->recorder);
}

}  // namespace teamsight::recording
