// monitor/recording_feed.hpp: the bus to viewers and into the station's recording, if there is one.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "monitor.pb.h"
#include "monitor/station.hpp"
#include "monitor/viewer/sink.hpp"
#include "recording/bus_recorder.hpp"
#include "recording/recorder.hpp"
#include "recording/scene.hpp"
#include "recording/topic_channel.hpp"

namespace teamsight::monitor {

/// The station's own events in a recording, as MonitorUpdate with nothing but events.
inline constexpr const char* kEventTopic = "teamsight/v1/Events";

/// Everything that the station passes on as it is: to viewers, and into files where --record asks.
class Recording {
 public:
  /// @param settings  nothing: nothing is recorded
  /// @param server    outlives this
  /// @throws recording::RecordingError if the folder cannot be had
  Recording(const std::optional<recording::RecorderSettings>& settings, WebServer& server)
      : recorder_(settings ? std::make_unique<recording::Recorder>(*settings) : nullptr),
        sink_(server, recorder_.get()) {}

  void attach(const bus::Participant& team, bus::Loop& loop) {
    feeds_ = std::make_unique<recording::BusRecorder>(team, loop, sink_);
    events_ = sink_.add_channel(
        {kEventTopic, "protobuf", recording::schema_of(*v1::MonitorUpdate::descriptor())});
    log_ = sink_.add_channel(recording::log_channel());
  }

  /// The station's own events, as MonitorUpdate and as a viewer's log.
  void add_events(const Update& update, const std::string& encoded) {
    if (update.events.empty()) return;
    sink_.write(events_, update.stamp, stamp_of(update.stamp), encoded);
    for (const Event& event : update.events) {
      const auto log_ns = (event.stamp.time_since_epoch() + sink_.log_minus_host()).count();
      sink_.write(log_,
                  event.stamp,
                  stamp_of(event.stamp),
                  recording::log_entry(level_of(event.level), "station", event.text, log_ns));
    }
  }

  void add_truth(const bus::Participant& match) { feeds_->add_truth(match); }

  /// For viewers that draw scenes; once a second.
  void draw(const FieldModel& field, HostTime now) { feeds_->draw(field, now); }

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
  static recording::LogLevel level_of(Level level) {
    if (level == Level::kInfo) return recording::LogLevel::kInfo;
    return level == Level::kWarning ? recording::LogLevel::kWarning : recording::LogLevel::kError;
  }

  std::unique_ptr<recording::Recorder> recorder_;
  StationSink sink_;
  std::unique_ptr<recording::BusRecorder> feeds_;
  recording::ChannelId events_{0};
  recording::ChannelId log_{0};
  std::string problem_;
};

}  // namespace teamsight::monitor
