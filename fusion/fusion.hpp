// fusion/fusion.hpp: the whole fusion as one value: observations in, world out, time as an
// argument.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fusion/ball_hint.hpp"
#include "fusion/observation.hpp"
#include "fusion/parameters.hpp"
#include "fusion/state.hpp"
#include "fusion/track_names.hpp"
#include "geometry/field_model.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::fusion {

/// What became of one observation.
enum class Intake : std::uint8_t { kAccepted, kDuplicate, kTooOld, kFromTheFuture, kTooMany };

/// Why one track is believed.
struct TrackReport {
  std::uint32_t track{0};
  bool is_ball{false};
  RobotMask supporters{0};
  RobotMask rejected{0};
  Duration born_ago{0};
  double nis{0.0};  ///< mean normalised innovation squared per degree of freedom; 0 = none yet
};

/// What became of one robot's observations since the start.
struct RobotReport {
  RobotId robot{kNobody};
  double trust{0.0};  ///< in [0, 1]
  Quarantine quarantine{Quarantine::kNone};
  std::uint32_t accepted{0};            ///< ball rays and obstacle sightings used
  std::uint32_t rejected_gate{0};       ///< ... that fitted nothing
  std::uint32_t rejected_late{0};       ///< frames too old, from the future, or too many
  std::uint32_t rejected_duplicate{0};  ///< frames that had come before
  std::uint32_t rejected_posture{0};    ///< frames unused for want of a posture
};

/// What became of the operator's newest hint.
struct HintReport {
  std::uint32_t number{0};  ///< BallHint::number; 0 = none came
  std::uint32_t track{0};   ///< the listed ball that it means; 0 = none
  Duration left{0};         ///< how long it still counts; 0 = over
};

struct Report {
  std::vector<TrackReport> tracks;
  std::vector<RobotReport> robots;  ///< by robot id
  HintReport hint;
};

/// Merges the observations of all robots, each at its own exposure, whatever the order of arrival.
///
/// Keeps the observations of the last `Parameters::lag`, ordered by (exposure, id), with the state
/// after each of them; one that arrives late is put in its place and all after it are taken in
/// again. The state is therefore a function of the set of observations alone: neither their order
/// of arrival nor duplicates change it. A value: copies share nothing. Use from one thread.
class Fusion {
 public:
  Fusion(const Parameters& parameters, const FieldModel& field);

  /// Takes one observation in.
  ///
  /// @param observation  valid: finite numbers, positive covariances, known robot
  /// @param now  does not go back from call to call
  Intake insert(const Observation& observation, HostTime now);

  /// Takes the operator's word about which ball is the game's. It decides which of the balls that
  /// are seen is listed first, for some seconds, and changes nothing else. The same hint again does
  /// nothing; another one replaces it.
  void take_hint(const BallHint& hint);

  /// The world predicted to `now`. Maker, count and strength are the caller's to fill in.
  [[nodiscard]] WorldModel world_at(HostTime now) const;

  /// Calls tracks by the names that `world` has for them: a track that lies within the gate of one
  /// of the world's tracks takes over its id.
  ///
  /// For a starting or following instance with the leader's world, and for a leading one with its
  /// own last world, so that ids survive fail-over and late observations. Changes names only.
  ///
  /// @param at  the world's moment in this host's time
  void adopt_ids(const WorldModel& world, HostTime at);

  /// Why things are as `world_at` shows them.
  [[nodiscard]] Report report_at(HostTime now) const;

  /// How many observations are held for re-filtering.
  [[nodiscard]] std::size_t held() const { return order_.size(); }

 private:
  struct Slot {
    Observation observation;
    State after;
  };

  /// Frames of one robot that are already folded into the checkpoint.
  struct Folded {
    std::uint32_t boot{0};
    std::uint32_t sequence{0};
  };

  [[nodiscard]] bool is_babbling(RobotId robot, HostTime now) const;
  [[nodiscard]] Intake judge(const Observation& observation, HostTime now) const;
  [[nodiscard]] std::size_t held_of(RobotId robot) const;
  void count(RobotId robot, Intake intake, HostTime now);
  void fold_front();
  [[nodiscard]] std::size_t place_of(const Observation& observation) const;
  void put(std::size_t place, const Observation& observation);
  void take_in_from(std::size_t place);
  [[nodiscard]] const State& head() const;
  [[nodiscard]] HintReport hint_at(HostTime now, const WorldModel& world) const;

  Setting setting_;
  BallHint hint_;
  State checkpoint_;
  HostTime folded_exposure_{kNever};
  ObservationId folded_id_;
  std::array<Folded, kMaxRobotId> folded_{};
  std::vector<Slot> slots_;         // never shrinks; spare ones are in spare_
  std::vector<std::size_t> order_;  // slots by (exposure, id)
  std::vector<std::size_t> spare_;
  std::array<std::uint32_t, kMaxRobotId> late_{};
  std::array<std::uint32_t, kMaxRobotId> duplicate_{};
  std::array<HostTime, kMaxRobotId> babbled_{no_robot_times()};
  TrackNames names_;
};

}  // namespace teamsight::fusion
