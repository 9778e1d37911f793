// agent/locator.hpp: the robot's localisation, fed by frames, wheels, the coach and the team.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "agent/search_thread.hpp"
#include "bus/messages.hpp"
#include "geometry/field_model.hpp"
#include "geometry/identity.hpp"
#include "geometry/world_model.hpp"
#include "vision/localisation/localisation.hpp"
#include "vision/perception.hpp"

namespace teamsight::agent {

/// Turns topics into what vision::Localiser takes in, and keeps its state and its background
/// search. Every stamp is in this computer's host time. Use from the loop's thread.
class Locator {
 public:
  Locator(const FieldModel& field, const vision::LocalisationParameters& parameters);

  /// Takes one frame's line points and goals in.
  [[nodiscard]] vision::PostureResult see(const vision::Perception::Cues& cues, HostTime exposure);

  /// What somebody said: put there by hand, or by the coach. @param cov  m, m, rad
  void place(const Pose<Field, Robot>& X_FR, const Eigen::Matrix3d& cov, HostTime when);

  /// What the wheels said, and gyro and compass where there are any.
  void roll(const bus::Odometry& odometry);

  /// What the team makes of this robot's half of the field.
  ///
  /// @param sightings  sequence of the newest Sightings that this robot sent
  void hear(const WorldModel& world, RobotId self, std::uint32_t sightings);

  /// Readable when a search is done.
  [[nodiscard]] int search_fd() const noexcept { return search_->event_fd(); }

  void take_answer();

  /// Velocity over the floor and turning rate (rad/s); zero if neither is known.
  [[nodiscard]] Velocity<Robot> velocity(HostTime when) const;
  [[nodiscard]] double omega(HostTime when) const;

  /// What the team told, of the posture as it stands now.
  [[nodiscard]] double team_log_odds() const { return state_.team_log_odds; }

  [[nodiscard]] const vision::LocalisationCounts& counts() const { return state_.counts; }

 private:
  [[nodiscard]] std::optional<vision::Hypothesis> moving(HostTime when) const;

  vision::Localiser localiser_;
  vision::LocalisationState state_;
  std::unique_ptr<SearchThread> search_;
  std::vector<vision::GoalBearing> goals_;  // of one frame; kept for its memory
  std::uint64_t flips_{0};                  // of which the team's evidence knows
  std::uint32_t flipped_after_{0};          // sequence of the last Sightings before the last flip
};

}  // namespace teamsight::agent
