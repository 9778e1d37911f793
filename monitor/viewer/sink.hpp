// monitor/viewer/sink.hpp: messages to the station's viewers and, if there is one, its recording.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "geometry/expect.hpp"
#include "monitor/web_server.hpp"
#include "recording/recorder.hpp"

namespace teamsight::monitor {

/// Both at once, so that each message is read from the bus and serialised once.
class StationSink : public recording::MessageSink {
 public:
  /// @param recorder  null: nothing is recorded; else, as the server, it outlives this
  StationSink(WebServer& server, recording::Recorder* recorder)
      : server_(&server),
        recorder_(recorder),
        log_minus_host_(recorder ? recorder->log_minus_host() : recording::wall_minus_host()) {}

  recording::ChannelId add_channel(recording::Channel channel) override {
    const recording::ChannelId id = server_->add_channel(channel);
    if (recorder_) TEAMSIGHT_EXPECT(recorder_->add_channel(std::move(channel)) == id);
    return id;
  }

  [[nodiscard]] bool is_wanted(recording::ChannelId channel) const override {
    return recorder_ != nullptr || server_->is_wanted(channel);
  }

  void write(recording::ChannelId channel,
             HostTime received,
             PeerTime stamp,
             std::string payload) override {
    if (server_->is_wanted(channel)) {
      server_->send(channel, (received.time_since_epoch() + log_minus_host_).count(), payload);
    }
    if (recorder_) recorder_->write(channel, received, stamp, std::move(payload));
  }

  [[nodiscard]] Duration log_minus_host() const override { return log_minus_host_; }

 private:
  WebServer* server_;
  recording::Recorder* recorder_;
  Duration log_minus_host_;
};

}  // namespace teamsight::monitor
