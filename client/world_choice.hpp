// client/world_choice.hpp: which of the world models that were heard to believe, and how old it is.
#pragma once

#include <cstdint>
#include <optional>

#include "client/world.hpp"
#include "geometry/time.hpp"
#include "geometry/world_model.hpp"

namespace teamsight {

/// Age of samples whose maker's clock is unknown: against the quickest sample of the same maker.
///
/// A sample that took longer than that one, on its way or lying unread, shows it in its age. What
/// the quickest took itself is missing: a few ms on a network. A value.
class RelativeAge {
 public:
  /// A sample of `maker` stamped `stamp` was taken at `now`.
  void heard(const ObservationId& maker, PeerTime stamp, HostTime now);

  /// Age at `now` of the maker's `stamp`.
  [[nodiscard]] Duration age_of(PeerTime stamp, HostTime now) const;

 private:
  std::uint32_t boot_{0};
  RobotId robot_{kNobody};
  HostTime begun_{};  // of the newer window
  // Smallest (taken - stamped) in this minute and the one before: two clocks drift apart.
  std::optional<Duration> newer_;
  std::optional<Duration> older_;
};

/// When a model is too old to be handed out.
struct FreshnessParameters {
  /// The leader's: whatever the network's lease is, a behaviour can do nothing with an older one,
  /// and its own host's is there.
  Duration leader{std::chrono::milliseconds(250)};
  Duration own_host{std::chrono::seconds(1)};
};

/// The leader's model while it is fresh, else the own host's, else none. Time as an argument.
class WorldChoice {
 public:
  explicit WorldChoice(const FreshnessParameters& parameters) : parameters_(parameters) {}

  void heard_leader(const WorldModel& model, HostTime now);

  /// Of this computer, so its clock is the own one.
  void heard_own_host(const WorldModel& model);

  [[nodiscard]] World freshest(HostTime now) const;

 private:
  FreshnessParameters parameters_;
  RelativeAge leader_clock_;
  std::optional<WorldModel> leader_;
  std::optional<WorldModel> own_host_;
};

}  // namespace teamsight
