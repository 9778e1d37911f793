// fusion/leadership.hpp: whether this instance's world model goes over the air.
#pragma once

#include <cstdint>

#include "geometry/identity.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

struct LeadershipParameters {
  /// Nothing heard from a stronger one for so long: it is gone. That of the topic's liveliness.
  Duration lease{std::chrono::milliseconds(200)};
  /// A leader yields when it has heard a stronger one for so long without a gap of a lease; one
  /// that stutters never silences one that works.
  Duration yield_after{std::chrono::milliseconds(100)};
  /// A starting instance lets a weaker leader go on for so long, while it gathers observations
  /// and learns the names of the tracks.
  Duration warm_up{std::chrono::seconds(1)};
};

/// Who sent a world model. The greater one leads.
struct Rank {
  std::uint16_t strength{0};
  RobotId robot{kNobody};  ///< decides between equal strengths

  friend bool operator==(const Rank&, const Rank&) = default;

  [[nodiscard]] bool is_below(const Rank& other) const {
    return strength != other.strength ? strength < other.strength : robot < other.robot;
  }
};

/// Decides from what is heard on the team's world model topic. A value; time as an argument.
class Leadership {
 public:
  Leadership(const Rank& own, const LeadershipParameters& parameters);

  /// Another instance's world model was heard at `now`.
  void heard(const Rank& other, HostTime now);

  /// Whether to send at `now`; to be asked at least twice per lease. A longer pause between two
  /// questions (the process was stopped) counts as a new start.
  [[nodiscard]] bool leads(HostTime now);

 private:
  [[nodiscard]] bool is_heard(HostTime when, HostTime now) const;

  Rank own_;
  LeadershipParameters parameters_;
  HostTime started_;  // when it was first asked, or asked again after a pause
  HostTime asked_;
  HostTime stronger_since_;  // begin of the present unbroken series of a stronger one
  HostTime stronger_heard_;
  HostTime other_heard_;  // anyone, weaker or stronger
  bool leads_{false};
};

}  // namespace teamsight::fusion
