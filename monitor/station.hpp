// monitor/station.hpp: samples in, what the operator sees out. No clock, no network.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bus/messages.hpp"
#include "bus/reader.hpp"
#include "bus/reject.hpp"
#include "fusion/service/clock_book.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"
#include "geometry/world_model.hpp"
#include "monitor/link_meter.hpp"
#include "monitor/other_stations.hpp"
#include "monitor/silence.hpp"
#include "monitor/update.hpp"

namespace teamsight::monitor {

struct StationParameters {
  Duration window{std::chrono::seconds(5)};  ///< rate, loss and latency are over this long
  /// A robot that says nothing for so long is reported silent, its camera lost. Longer than a
  /// lease, so that a busy computer's hiccup shows in the table but does not fill the log.
  Duration silent_after{std::chrono::milliseconds(600)};
  Duration world_late_after{std::chrono::seconds(1)};  ///< a world older than this is no picture
  Duration other_station_gone_after{std::chrono::seconds(5)};  ///< one that says nothing so long
  Duration duplicate_for{std::chrono::seconds(2)};  ///< how long a shared robot id is remembered
  std::string
      version;  ///< of this station; a robot that runs another is named. Empty: not compared
  std::uint32_t boot{1};     ///< of this process, as others answer its questions; not 0
  bool is_recording{false};  ///< what it hears is over: a station that speaks in it is no other
  std::string where;  ///< named when nothing is heard, e.g. "domain 7 (config/teams/a.textproto)"
};

/// Keeps the newest of every topic and notices what changes. A value: copy it, ask it, drop it.
///
/// Samples must be handed over in the order they were received.
class Station {
 public:
  explicit Station(StationParameters parameters);

  void hear(const bus::Sample<bus::RobotState>& sample);
  void hear(const bus::Sample<bus::Sightings>& sample);
  void hear(const bus::Sample<WorldModel>& sample);
  void hear(const bus::Sample<bus::Explanation>& sample);
  void hear(const bus::Sample<bus::Diagnostics>& sample);
  void hear(const bus::Sample<bus::Truth>& sample);
  void hear(const bus::Sample<bus::LinePoints>& sample);
  void hear(const bus::Sample<bus::Thumbnail>& sample);
  void hear(const bus::Sample<bus::VirtualSensors>& sample);
  void hear(const bus::Sample<bus::ClockEcho>& sample);

  /// The next question for the time of every robot's computer, to be written at once. Without
  /// answers, stamps that can be of this computer's clock are taken to be so.
  [[nodiscard]] bus::ClockProbe next_probe(HostTime now) { return clocks_.next_probe(now); }

  /// Something that happened elsewhere in the station, for the log.
  void note(HostTime stamp, Level level, std::string text);

  /// The other versions of the topics that are spoken in the domain now, e.g. "v2".
  void note_versions(const std::set<std::string>& others, HostTime now);

  /// Who announces himself in other domains now, e.g. "domain 22 (blue)"; empty: nobody.
  void note_domains(std::string others) { other_domains_ = std::move(others); }

  /// What a reader has dropped until now.
  void count(std::string_view topic, const bus::ReadCounters& counters);

  /// Everything to show at `now`, with the events since the last call.
  [[nodiscard]] Update update(HostTime now);

  /// The leader's newest; null: none yet. Valid until the next `hear`.
  [[nodiscard]] const WorldModel* world() const { return world_ ? &*world_ : nullptr; }

  /// How old the world's stamp is: since it arrived, and on the way if its maker's clock is known.
  [[nodiscard]] Duration world_information_age(HostTime now) const;

  /// The newest state of every robot, by id. Valid until the next `hear`.
  [[nodiscard]] std::vector<const bus::RobotState*> states() const;

  /// Robots whose lease holds.
  [[nodiscard]] std::vector<RobotId> alive() const;

 private:
  struct Watch {
    explicit Watch(Duration window) : link(window) {}

    bool alive{false};
    bool was_heard{false};
    bool is_reported_silent{false};
    bool is_camera_reported{false};  ///< as lost
    std::optional<HostTime> camera_lost_since;
    HostTime heard;
    HostTime shared_id_seen;
    std::uint32_t boot{0};
    std::uint32_t boot_before{0};
    LinkMeter link;
    std::optional<bus::RobotState> state;
    std::optional<bus::Diagnostics> agent;
    std::optional<bus::ExplainedRobot> explained;
    std::optional<bus::Sightings> sightings;
    std::optional<bus::LinePoints> line_points;
    HostTime line_points_heard;
    std::optional<bus::VirtualSensors> sensors;
    HostTime sensors_heard;
    Quarantine quarantine{Quarantine::kNone};
  };

  Watch& watch_of(RobotId robot);
  [[nodiscard]] std::optional<Duration> way_of(RobotId robot, PeerTime stamp, HostTime heard) const;
  void note_boot(RobotId robot, Watch& watch, std::uint32_t boot, HostTime now);
  void note_silence(RobotId robot, Watch& watch, HostTime now);
  void note_arrival(RobotId robot, Watch& watch, HostTime now);
  void note_camera(RobotId robot, Watch& watch, bool is_lost, HostTime now);
  void note_version(RobotId robot, const Watch& watch, const bus::RobotState& state, HostTime now);
  [[nodiscard]] bool is_other_version(const bus::RobotState& state) const;
  void note_other_station(std::uint32_t boot, HostTime now);
  void note_hint(const bus::ExplainedHint& hint, HostTime now);
  [[nodiscard]] std::optional<bus::ExplainedHint> hint_at(HostTime now) const;
  void note_quarantines(const WorldModel& world, HostTime now);
  [[nodiscard]] RobotRow row_of(RobotId robot, const Watch& watch, HostTime now) const;
  [[nodiscard]] Surroundings surroundings() const;

  StationParameters parameters_;
  fusion::ClockBook clocks_;
  std::map<RobotId, Watch> robots_;
  std::map<std::uint64_t, RobotId> robot_of_instance_;
  std::optional<WorldModel> world_;
  HostTime world_heard_;
  bus::ExplainedHint hint_;
  std::uint32_t hint_told_{0};  ///< the command of which it was said that it counts
  HostTime hint_heard_;
  std::optional<bus::Truth> truth_;
  HostTime truth_heard_;
  std::map<std::string, bus::Diagnostics, std::less<>> processes_;
  std::map<std::string, std::uint64_t, std::less<>> rejected_;
  std::vector<bus::Thumbnail> thumbnails_;
  std::string other_versions_;  ///< e.g. "v2"; empty: none
  std::string other_domains_;
  OtherStations other_stations_;
  std::vector<Event> events_;
};

}  // namespace teamsight::monitor
