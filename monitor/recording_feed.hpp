// monitor/recording_feed.hpp: the station's recording, if there is one, and what is said about it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "monitor.pb.h"
#include "monitor/station.hpp"
#include "recording/bus_recorder.hpp"
#include "recording/recorder.hpp"
#include "recording/topic_channel.hpp"

namespace teamsight::monitor {

/// The station's own events in a recording, as MonitorUpdate with nothing but events.
inline constexpr const char* kEventTopic = "teamsight/v1/Events";

/// Everything that is written down, where --record asks for it.
class Recording {
 public:
  /// @param settings  nothing: nothing is recorded
  /// @throws recording::RecordingError if the folder cannot be had
  explicit Recording(std::optional<recording::RecorderSettings> settings) {
    if (settings) recorder_ = std::make_unique<recording::Recorder>(std::move(*settings));
  }

  void attach(const bus::Participant& team, bus::Loop& loop) {
    if (!recorder_) return;
    feeds_ = std::make_unique<recording::BusRecorder>(team, loop, *recorder_);
    events_ = recorder_->add_channel(
        {kEventTopic, "protobuf", recording::schema_of(*v1::MonitorUpdate::descriptor())});
  }

  /// @param events  an encoded MonitorUpdate; nothing is written of an empty one
  void add_events(const std::string& events, HostTime now) {
    if (recorder_ && !events.empty()) recorder_->write(events_, now, stamp_of(now), events);
  }

  void add_truth(const bus::Participant& match) {
    if (feeds_) feeds_->add_truth(match);
  }

  /// What to show; a problem that begins or ends is noted.
  std::optional<recording::RecorderReport> report(Station& station, HostTime now) {
    if (!recorder_) return std::nullopt;
    recording::RecorderReport report = recorder_->report();
    if (report.problem != problem_) {
      const bool is_well = report.problem.empty();
      station.note(now,
                   is_well ? Level::kInfo : Level::kAlarm,
                   is_well ? "The recording goes on" : "Not recording: " + report.problem);
      problem_ = report.problem;
    }
    return report;
  }

 private:
  std::unique_ptr<recording::Recorder> recorder_;
  std::unique_ptr<recording::BusRecorder> feeds_;
  recording::ChannelId events_{0};
  std::string problem_;
};

}  // namespace teamsight::monitor
