// process/governor.hpp: what a team may still say when the air is full. A value; time as an
// argument.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "geometry/time.hpp"

namespace teamsight::process {

/// What is left out, in this order; each step holds the ones before it. A robot's posture and its
/// ball rays always go out with every frame.
enum class Thrift : std::uint8_t {
  kNone,
  kRareDiagnostics,  ///< Diagnostics and Explanation a third as often, no LinePoints, no Thumbnail
  kNearObstacles,    ///< raw obstacles only within 4 m of the ball, or of the robot if it sees none
  kSlowWorld,        ///< the leader's WorldModel over the air at 15 Hz; to its own host as ever
  kNoObstacles,      ///< no raw obstacles at all
};

inline constexpr Thrift kMostThrift = Thrift::kNoObstacles;

/// For an operator: what is left out, in a few words; empty for kNone.
[[nodiscard]] std::string_view to_text(Thrift thrift);

struct GovernorParameters {
  double budget_bps{2.2e6};  ///< bit/s on the wire; where the league's monitor raises its alarm
  double begin{0.95};        ///< of the budget: a forecast above it costs the next thing
  double end{0.80};          ///< of the budget: below it for `calm` gives the last thing back
  Duration calm{std::chrono::seconds(5)};
  Duration memory{
      std::chrono::seconds(5)};  ///< a process that says nothing for so long sends nothing
  /// What a process says in its first seconds is mostly discovery, which no thrift makes less.
  Duration settling{std::chrono::seconds(4)};
};

/// Adds up what every process of the team says that it sends, and decides how much thrift it takes.
class Governor {
 public:
  explicit Governor(const GovernorParameters& parameters);

  /// A process (this one included) has sent `bps` bit/s over its last second.
  void heard(std::string_view process, double bps, HostTime now);

  /// To be called once a second. One step up at a time when the forecast is over the budget, one
  /// down after a while of calm.
  Thrift step(HostTime now);

  [[nodiscard]] Thrift thrift() const { return thrift_; }

  /// The team's rate now.
  [[nodiscard]] double team_bps(HostTime now) const;

 private:
  struct Share {
    double bps{0.0};
    double before_bps{0.0};
    HostTime heard;
    HostTime first;  // when it was heard for the first time
  };

  [[nodiscard]] double forecast_bps(HostTime now) const;

  GovernorParameters parameters_;
  std::map<std::string, Share, std::less<>> shares_;
  Thrift thrift_{Thrift::kNone};
  HostTime not_calm_{};
};

}  // namespace teamsight::process
