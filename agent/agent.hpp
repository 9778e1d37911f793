// agent/agent.hpp: the process on a robot: frames in, topics out. One turn is one frame.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "agent/carried_out.hpp"
#include "agent/frame_thread.hpp"
#include "agent/light_follower.hpp"
#include "agent/locator.hpp"
#include "agent/translate.hpp"
#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"
#include "geometry/identity.hpp"
#include "process/air_share.hpp"
#include "process/hearing.hpp"
#include "process/meter.hpp"
#include "process/token_bucket.hpp"
#include "vision/line_drift.hpp"
#include "vision/perception.hpp"

namespace teamsight::agent {

/// Every reader and writer of the process; made at start, before any traffic.
struct AgentBus {
  /// Both must outlive it.
  AgentBus(bus::Participant& team, const bus::Participant& host);

  bus::Participant* team;

  bus::Writer<bus::RobotState> states;
  bus::Writer<bus::Sightings> sightings;
  bus::Writer<bus::LinePoints> line_points;
  bus::Writer<bus::Diagnostics> diagnostics;
  bus::Reader<bus::RobotState> peers;
  bus::Reader<bus::Command> commands;
  bus::Reader<WorldModel> worlds;
  bus::Reader<bus::Odometry> odometry;
  bus::Writer<bus::VirtualSensors> sensors;
  bus::Writer<bus::Thumbnail> thumbnails;
  bus::Writer<bus::VirtualSensors> shown_sensors;  ///< to the team, beside the thumbnails
};

/// Who this agent is and what it starts from.
struct AgentIdentity {
  RobotId robot{kNobody};
  std::uint32_t boot{0};
  std::string software_version;
};

/// Keeps a frame source, the vision and the topics together. Use from the loop's thread.
class Agent {
 public:
  Agent(AgentIdentity identity,
        AgentBus& bus,
        FrameThread& frames,
        std::unique_ptr<vision::Perception> perception,
        std::unique_ptr<Locator> locator);

  /// Puts everything the agent reacts to into the loop.
  void join(bus::Loop& loop);

  /// Whether an older process with the same robot id made this one give up.
  [[nodiscard]] bool has_yielded() const { return yielded_; }

  /// Who speaks under this robot's id as well, and what to do; "" if nobody was heard.
  [[nodiscard]] const std::string& rival() const { return rival_; }

 private:
  struct Seen {
    const vision::FrameObservation* observation{nullptr};
    HostTime exposure{};
    vision::ImageView frame;
  };

  void turn();
  void write(const Seen& seen);
  void show(const Seen& seen, HostTime now);
  void show_line_points(const Seen& seen, HostTime now);
  void show_picture(const Seen& seen, HostTime now);
  void write_state(HostTime now);
  void keep_alive();
  void diagnose();
  void listen_to_commands();
  bool carry_out(const bus::Command& command, HostTime now);
  void listen_to_wheels();
  void listen_to_team();
  void listen_to_peers();
  void measure_rate(HostTime exposure);
  void count_reject(vision::FrameReject reason);
  [[nodiscard]] bool is_camera_lost(HostTime now) const;
  [[nodiscard]] std::string complaint(const SourceReport& source, HostTime now) const;

  AgentIdentity identity_;
  AgentBus* bus_;
  FrameThread* frames_;
  std::unique_ptr<vision::Perception> perception_;
  std::unique_ptr<Locator> locator_;
  LightFollower light_;
  process::ProcessMeter meter_;
  process::AirShare air_;
  process::TokenBucket picture_air_;
  process::Hearing hearing_;
  bus::Loop* loop_{nullptr};

  PostureEstimate posture_;  // of the newest frame
  vision::DriftWatch drift_;
  HostTime exposure_{};       // of the newest frame; zero: none yet
  HostTime posture_found_{};  // when it last was not lost
  bool sees_ball_{false};
  std::uint64_t carpet_luminance_{0};  // of the newest frame; grey levels, 0: no carpet seen
  double frame_period_{0.0};           // s, smoothed; 0: not known
  double cpu_load_{0.0};
  double cpu_temperature_{0.0};  // degrees Celsius; 0 = not measured
  std::string reject_;           // why the newest frame said nothing; empty if it did

  std::uint32_t state_count_{0};
  std::uint32_t sightings_count_{0};
  std::uint32_t line_points_count_{0};
  std::uint32_t thumbnail_count_{0};
  std::uint32_t sensors_count_{0};
  HostTime state_written_{};
  HostTime line_points_until_{};
  HostTime line_points_written_{};
  HostTime pictures_until_{};
  HostTime picture_written_{};
  CarriedOut carried_out_;
  std::uint32_t acknowledged_{0};
  bool muted_{false};
  bool yielded_{false};
  std::string rival_;
  HostTime rival_heard_{};
};

}  // namespace teamsight::agent
