// vision/localisation/half_odds.hpp: which of the two images of a posture is the right one.
#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "geometry/field_model.hpp"
#include "geometry/pose.hpp"
#include "geometry/time.hpp"
#include "vision/goal_detector.hpp"
#include "vision/posture.hpp"

namespace teamsight::vision {

/// A heading measured against something outside, such as the magnetic field.
struct CompassReading {
  HostTime stamp{};
  double heading{0.0};  ///< of R's x axis in F; rad
  double sigma{0.3};    ///< rad
};

/// A goal of a known colour, as a camera sees it.
struct GoalBearing {
  GoalColour colour{GoalColour::kNone};
  double azimuth{0.0};  ///< of its middle in R; rad
  double sigma{0.1};    ///< rad
};

/// The bearing of a goal found in a frame. Of one that is partly hidden the middle is not seen:
/// it may lie anywhere within a goal's width.
[[nodiscard]] GoalBearing bearing_of(const SeenGoal& goal);

/// Log-odds that `X_FR` is right rather than its mirror image, from one compass reading. One
/// reading in twenty is taken to say nothing: motors have magnets.
[[nodiscard]] double half_log_odds_from_compass(const Pose<Field, Robot>& X_FR,
                                                const CompassReading& compass);

/// The same from goals whose colours the field tells apart; 0 where it does not. One sighting in
/// ten is taken to be something else of that colour.
[[nodiscard]] double half_log_odds_from_goals(const Pose<Field, Robot>& X_FR,
                                              const FieldModel& field,
                                              std::span<const GoalBearing> goals);

/// The same for a robot that was not where it was expected, and is found at `X_FR`: it went on as
/// expected, or something pushed it, or it was carried to anywhere on the carpet. Nothing tells
/// beforehand which of the three, so they count alike, each by its density there. What was carried
/// may stand on either half: near 0 where only that explains the place.
///
/// @pre expected.X_FR is there
/// @param expected  where it would be if it had gone on as expected; its covariance holds the
///                  uncertainty of `X_FR` as well
/// @param reach     how far a push can have moved and turned it; m and rad, over 0
[[nodiscard]] double half_log_odds_after_jump(const Pose<Field, Robot>& X_FR,
                                              const MotionPrior& expected,
                                              double reach,
                                              const FieldModel& field);

}  // namespace teamsight::vision
