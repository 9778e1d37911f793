// fusion/service/service.hpp: the process `teamsight-fusion`: topics in, fusion, topics out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"
#include "fusion/fusion.hpp"
#include "fusion/leadership.hpp"
#include "fusion/service/clock_book.hpp"
#include "process/air_share.hpp"
#include "process/hearing.hpp"
#include "process/meter.hpp"

namespace teamsight::fusion {

/// Who this instance is.
struct ServiceIdentity {
  RobotId robot{kNobody};
  std::uint16_t strength{0};
  std::uint32_t boot{0};
};

/// One fusion instance between the team's domain and its own host's. One thread: the loop's.
class Service {
 public:
  /// @param team  the domain between the robots; both must outlive the service
  /// @param host  the domain inside this computer
  Service(bus::Participant& team,
          const bus::Participant& host,
          const ServiceIdentity& identity,
          Fusion fusion);

  /// Hangs the service's handlers into the loop, which must not run longer than the service lives.
  void attach(bus::Loop& loop);

  /// Whether it stopped the loop because an older fusion has this robot's id.
  [[nodiscard]] bool has_yielded() const { return has_yielded_; }

  /// Who that is, and what to do.
  [[nodiscard]] const std::string& rival() const { return rival_; }

 private:
  void take_sightings(HostTime now);
  void take_sample(const bus::Sightings& sightings, HostTime now);
  void take_worlds(HostTime now);
  void take_probes(HostTime now);
  void judge_rival(const bus::Sample<bus::ClockProbe>& sample);
  void end_second(HostTime now);
  void take_echoes(HostTime now);
  void take_commands(HostTime now);
  void turn(HostTime now);
  void publish_world(HostTime now, bool leads);
  void publish_explanation(HostTime now);
  void write_explanation(HostTime now);
  void publish_diagnostics(HostTime now);
  void publish_probe(HostTime now);
  void speak(WorldModel& world, HostTime now);

  ServiceIdentity identity_;
  Fusion fusion_;
  Leadership leadership_;
  ClockBook clocks_;
  process::ProcessMeter meter_;
  process::AirShare air_;
  process::Hearing hearing_;
  bus::Reader<bus::Sightings> sightings_;
  bus::Reader<WorldModel> worlds_;
  bus::Reader<bus::ClockProbe> probes_;
  bus::Reader<bus::ClockEcho> echoes_;
  bus::Reader<bus::Command> commands_;
  bus::Writer<WorldModel> team_world_;
  bus::Writer<WorldModel> host_world_;
  bus::Writer<bus::Explanation> explanation_;
  bus::Writer<bus::ClockProbe> probe_;
  bus::Writer<bus::ClockEcho> echo_;
  bus::Writer<bus::Diagnostics> diagnostics_;
  WorldModel last_world_;
  bus::Loop* loop_{nullptr};
  HostTime started_{};
  HostTime published_{};
  HostTime spoken_{};  // over the air
  HostTime last_intake_{};
  HostTime probed_{};
  std::optional<bus::Diagnostics> last_report_;  // of a second process
  std::string rival_;
  HostTime rival_heard_{};
  int last_reports_{0};          // how often it was said
  std::uint32_t host_count_{0};  // models to the own host
  std::uint32_t air_count_{0};   // models over the air
  std::uint32_t explanation_count_{0};
  std::uint32_t hinted_{0};  // the command of the newest ball hint
  bool has_news_{false};
  bool has_yielded_{false};
};

}  // namespace teamsight::fusion
