// fusion/trust.hpp: which robots agree with which, and who is therefore not believed.
#pragma once

#include <array>

#include "fusion/parameters.hpp"
#include "fusion/track_book.hpp"
#include "geometry/identity.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::fusion {

/// What a look at one robot's frame says about it and one other robot.
struct PairEvidence {
  RobotId other{kNobody};
  double agreement{0.0};  ///< log-odds that the robot stands where it says rather than anywhere
  double same_half{0.0};  ///< log-odds that it stands there rather than at the mirror image
};

/// One robot in the book.
struct TrustPage {
  HostTime looked{kNever};  ///< when its evidence was gathered last
  HostTime seen{kNever};
  HostTime held{kNever};  ///< when `verdict` was last found
  Quarantine verdict{Quarantine::kNone};
  double own_half{0.0};  ///< its own log-odds
  double bias{0.0};      ///< squared normalised offset of its posture, smoothed
  int elsewhere{0};      ///< looks in a row that were explained by another posture
  /// It was found to stand elsewhere than it says. That does not mend by itself: it lasts until
  /// others agree with it, or until its posture jumps.
  bool is_carried{false};
};

/// Gathers evidence by pairs of robots, so that no robot is judge in its own cause, and judges by
/// what most of them explain best. A plain value.
class TrustBook {
 public:
  /// Whether it is time to look at this robot's frame.
  [[nodiscard]] bool is_due(RobotId robot,
                            HostTime exposure,
                            const TrustParameters& parameters) const;

  /// Notes a robot's own log-odds of its half and how far its posture seems aside.
  ///
  /// @param offset  squared, normalised
  void note(RobotId robot, HostTime exposure, double own_half, double offset);

  /// Notes log-odds that another posture explains what its frame shows. Who is found elsewhere in
  /// one look after the other is not believed until others agree with it.
  void note_elsewhere(RobotId robot,
                      HostTime exposure,
                      double log_odds,
                      const TrustParameters& parameters);

  /// Begins a look at a robot's frame: older evidence about it fades.
  void begin_look(RobotId robot, HostTime exposure, const TrustParameters& parameters);

  void add(RobotId robot, const PairEvidence& evidence, const TrustParameters& parameters);

  /// Its posture jumped to its mirror image: evidence on the half turns over.
  void turn_over(RobotId robot);

  /// Its posture jumped elsewhere, or another process speaks: evidence is void.
  void forget(RobotId robot);

  /// Its posture jumped: it is not believed for a while.
  void hold(RobotId robot, HostTime exposure);

  /// It says that it stands where no robot can: it is not believed until others agree with it.
  void banish(RobotId robot, HostTime exposure);

  /// Its posture was found to be biased (fusion/aside.hpp); not if it is worse than that.
  void set_aside(RobotId robot, HostTime exposure);

  /// Finds who is not to be believed, from all evidence.
  void judge(HostTime exposure, const TrustParameters& parameters);

  [[nodiscard]] Quarantine verdict(RobotId robot,
                                   HostTime now,
                                   const TrustParameters& parameters) const;

  /// Log-odds that the robot is in the half it says, from how its sightings compare with those of
  /// the others and how sure these are of their own halves; its own log-odds are not in it.
  [[nodiscard]] double half_log_odds(RobotId robot, const TrustParameters& parameters) const;

  /// In [0, 1]: 0 while it is not believed, less than 1 where its posture seems aside.
  [[nodiscard]] double trust(RobotId robot, HostTime now, const TrustParameters& parameters) const;

 private:
  using Pairs = std::array<std::array<double, kMaxRobotId>, kMaxRobotId>;

  struct Active {
    std::array<std::size_t, kMaxRobotId> index{};
    std::size_t count{0};
  };

  static void fade(Pairs& pairs, RobotId robot, double keep);
  [[nodiscard]] Active active_at(HostTime exposure) const;
  void judge_halves(const Active& active, HostTime exposure, const TrustParameters& parameters);
  void judge_places(const Active& all, HostTime exposure, const TrustParameters& parameters);
  void keep_carried(const Active& active, HostTime exposure, const TrustParameters& parameters);
  [[nodiscard]] double pair_agreement(std::size_t a,
                                      std::size_t b,
                                      const TrustParameters& parameters) const;
  [[nodiscard]] bool is_found_at_mirror(std::size_t i, const Active& active, unsigned turned) const;
  void convict(std::size_t index, Quarantine verdict, HostTime exposure);
  [[nodiscard]] double gain_of(const Active& active,
                               unsigned turned,
                               const TrustParameters& parameters) const;
  [[nodiscard]] double gain_of_carried(const Active& active,
                                       unsigned carried,
                                       const TrustParameters& parameters) const;

  std::array<TrustPage, kMaxRobotId> pages_{};
  Pairs agreement_{};
  Pairs same_half_{};
  Pairs at_mirror_{};  ///< log-odds that one of the pair stands at its mirror image, not anywhere
};

}  // namespace teamsight::fusion
