// bench/play/play_log.hpp: one seed of one scenario, whole: the truth, and what was delivered when.
#pragma once

#include <array>
#include <vector>

#include "bench/play/eyes.hpp"
#include "bench/play/scenario.hpp"

namespace teamsight::play {

/// A frame on arrival.
struct Delivery {
  double arrival{0.0};  ///< s
  std::size_t frame{0};
  HostTime exposure{};  ///< as the receiver dates it
  Duration sigma_exposure{0};
};

struct PlayLog {
  Scenario scenario;
  bool has_known_errors{false};      ///< drawn by `scenario.perception`: there is a bound
  std::vector<Moment> moments;       ///< every Play::kStep, from 0
  std::vector<Frame> frames;         ///< by exposure
  std::vector<Delivery> deliveries;  ///< by arrival
  double worst_clock_error{0.0};     ///< s, of the estimates used

  /// The moment nearest to `t`.
  [[nodiscard]] const Moment& at(double t) const;

  /// The delivered observation, as an estimator gets it.
  [[nodiscard]] fusion::Observation observation(const Delivery& delivery) const;
};

/// 22 x 14 m with a metre of surround: all that fusion asks of a field.
[[nodiscard]] FieldModel play_field();

/// Plays `seconds` of the scenario. The same seed gives the same log.
[[nodiscard]] PlayLog play_log(const Scenario& scenario, std::uint64_t seed, double seconds);

/// The same play, looked at with other eyes; made for as many robots as the scenario has.
[[nodiscard]] PlayLog play_log(const Scenario& scenario,
                               std::uint64_t seed,
                               double seconds,
                               Eyes& eyes);

}  // namespace teamsight::play
