// bench/play/network.hpp: what the air and the clocks do to frames on their way.
#pragma once

#include <optional>

#include "bench/play/play.hpp"
#include "fusion/clock_offset.hpp"
#include "geometry/time.hpp"

namespace teamsight::play {

struct NetworkParameters {
  double loss{0.0};         ///< share of frames that never arrive
  double processing{0.02};  ///< s from exposure to the air
  double min_delay{0.001};  ///< s in the air
  double max_delay{0.005};  ///< s; uniform between the two, each frame for itself
  double duplicates{0.0};   ///< share of frames that arrive twice
};

struct ClockParameters {
  double sigma_offset{0.0};  ///< s; drawn once per robot
  double max_drift{0.0};     ///< s/s; uniform within +-, drawn once per robot
  bool is_unknown{false};    ///< offsets have to be estimated by exchanges
};

/// One robot's clock, as the receiver of its frames learns to know it.
class PeerClockModel {
 public:
  PeerClockModel(const ClockParameters& clocks, const NetworkParameters& network, Random& random);

  /// Goes on to `t` (s, receiver's time), with an exchange each second, five in the first.
  void advance_to(double t, Random& random);

  struct Converted {
    HostTime time;
    Duration sigma{0};
  };

  /// An exposure of this robot, as its receiver dates it at `now`.
  ///
  /// @return nothing while the clock is unknown
  [[nodiscard]] std::optional<Converted> convert(double exposure, double now) const;

  /// Error of the present estimate; s. Nothing while there is none.
  [[nodiscard]] std::optional<double> error_at(double now) const;

 private:
  [[nodiscard]] PeerTime peer_time(double t) const;

  ClockParameters clocks_;
  NetworkParameters network_;
  double offset_;
  double drift_;
  double next_exchange_{0.0};
  fusion::ClockOffset estimate_;
};

/// The receiver's time of a moment of the play; late enough for all windows.
[[nodiscard]] HostTime host_time(double t);

}  // namespace teamsight::play
