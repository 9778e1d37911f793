// tests/network/stage.hpp: what all scenarios share: a running team and the usual questions about
// it.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/network/judge.hpp"
#include "tests/network/scenarios.hpp"
#include "tests/network/team.hpp"

namespace teamsight::network {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// The bit mask of robots 1 to `robots`.
[[nodiscard]] std::uint8_t everybody(RobotId robots);

/// What every host had sent by then.
struct WireMark {
  std::int64_t at_ns{0};
  std::vector<std::uint64_t> bytes;
};

/// Hosts with one team on them, and the outcome that is being written.
class Stage {
 public:
  /// @param more_hosts  beside those of the team and its coach
  Stage(const std::string& scenario,
        const ScenarioOptions& options,
        const TeamOptions& team,
        std::size_t more_hosts = 0);

  Hosts hosts;
  Team team;
  Outcome outcome;

  /// How long the scenario observes: `base`, stretched by the options.
  [[nodiscard]] milliseconds observed(milliseconds base) const;

  /// Starts everything and waits until every robot is in every behaviour's model for half a second.
  /// Says how long that took.
  /// @return that, in ms
  double start();

  /// Lets it run and returns the interval.
  [[nodiscard]] Interval run_for(milliseconds duration) const;

  /// One line per robot, and what went over the wire since the start or the report before. Returns
  /// the worst of each figure, but of the share over the air the mean of those robots that did not
  /// lead themselves, and of the ball the RMS over the team: what one robot saw go wrong in a few
  /// seconds is a kick or two that came while nothing arrived.
  Knowledge report(const std::string& title, const Interval& interval);

  /// Bytes per robot and team on the wire over a stretch of calm or foul weather.
  double report_wire(milliseconds duration);

  /// What the last `report_wire` saw and what the start took, by topic and host, and the mean of
  /// everything since the first process began. Ends robot 1's agent, which knows the names.
  void report_topics();

  /// Waits until the claim holds for good on every robot's channel, at most `bound`; says when,
  /// from `from_ns`, the last robot got there, in ms; negative: not all did.
  double await(Channel channel, std::int64_t from_ns, milliseconds bound, const Claim& claim);

 private:
  [[nodiscard]] WireMark mark();
  double say_wire(const WireMark& since);

  double length_;
  std::optional<WireMark> marked_;  // since when the next report tells what went over the wire
  [[nodiscard]] std::string topic_line(const std::string& topic,
                                       const std::map<WriterGuid, std::string>& topics) const;

  BytesByWriter wire_at_start_;
  BytesByWriter wire_before_;
  BytesByWriter wire_after_;
  std::int64_t started_ns_{0};
  double wire_seconds_{1.0};
};

/// Options of a team by a scenario's options.
[[nodiscard]] TeamOptions team_of(const ScenarioOptions& options);

/// The lease of the profile that the team uses.
[[nodiscard]] milliseconds lease_of(const ScenarioOptions& options);

/// "12.3", for lines.
[[nodiscard]] std::string number(double value, int digits = 1);

}  // namespace teamsight::network
