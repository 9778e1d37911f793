// fusion/state.hpp: everything fusion believes at one moment, and how one observation changes it.
#pragma once

#include "fusion/aside.hpp"
#include "fusion/ball_hint.hpp"
#include "fusion/ball_identity.hpp"
#include "fusion/ball_track.hpp"
#include "fusion/observation.hpp"
#include "fusion/obstacle_identity.hpp"
#include "fusion/parameters.hpp"
#include "fusion/team_errors.hpp"
#include "fusion/teammate.hpp"
#include "fusion/track.hpp"
#include "fusion/trust.hpp"
#include "fusion/unseen.hpp"
#include "geometry/field_model.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::fusion {

/// A plain value; the result of a sequence of observations and of nothing else.
struct State {
  BallList balls;
  std::uint32_t lost_ball{0};  ///< key of the track that was given up last; 0: none
  KickTally kicks;             ///< of this game
  HintedBall hinted;           ///< by the operator; decides which ball is listed first, no more
  TrackList obstacles;
  KnownObstacles lost_obstacles;                ///< that were dropped not long ago
  UnseenMap unseen;                             ///< obstacles that are in no track
  InlineList<Teammate, kMaxRobotId> teammates;  ///< in the order in which they were first seen
  TeamErrors errors;
  AsideBook aside;
  TrustBook trust;
};

/// What every observation is taken in with.
struct Setting {
  Parameters parameters;
  FieldModel field;
};

/// Takes one observation in.
///
/// Sightings of a robot without a resolved posture, under whose id two processes speak, or that
/// the others contradict, are not used. Sighted obstacles are given to teammates first, which
/// tells of both robots' postures, then to obstacle tracks.
///
/// @pre observations come in the order of their exposures, and are valid
void advance(State& state, const Observation& observation, const Setting& setting);

/// Why this robot's observations are not used at `now`.
[[nodiscard]] Quarantine quarantine_at(const State& state,
                                       const Teammate& teammate,
                                       HostTime now,
                                       const Parameters& parameters);

/// The world at `now`, without maker and strength; track ids are the tracks' keys.
///
/// Tracks of which the last observation is later than `now` are given as of that observation.
[[nodiscard]] WorldModel world_of(const State& state, HostTime now, const Parameters& parameters);

}  // namespace teamsight::fusion
