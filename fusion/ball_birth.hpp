// fusion/ball_birth.hpp: what is thought of a ball that is seen for the first time.
#pragma once

#include "fusion/ball_beliefs.hpp"
#include "fusion/ball_view.hpp"
#include "fusion/team_errors.hpp"
#include "fusion/track.hpp"

namespace teamsight::fusion {

/// What a track of a ball begins with.
struct BallBirth {
  const Candidate& candidate;
  const BallRay& ray;
  const BallObserver& observer;
  const TeamErrors& errors;
  const BallMotion& motion;
  double sigma_speed{0.0};  ///< m/s, per component
};

/// The possibilities of a ball seen once: that it rolls where the ray meets the floor, or flies
/// nearer by. Of a candidate in the air (Candidate::is_high): that it flies where its size says.
[[nodiscard]] BallBeliefs beliefs_at_birth(const BallBirth& birth,
                                           RobotId robot,
                                           HostTime exposure);

}  // namespace teamsight::fusion
