// vision/mirror/failure.hpp: why a mirror design does not close.
#pragma once

#include <cstdint>
#include <string>

namespace teamsight::mirror {

/// The condition that a design breaks.
enum class Condition : std::uint8_t {
  kSolution,    ///< the parts cannot be joined with these parameters
  kFunction,    ///< the profile is not a function of the distance from the axis
  kSlopeJump,   ///< the tangent jumps where it must not
  kFacing,      ///< part of the mirror turns away from the camera
  kSecondHit,   ///< a reflected ray meets the mirror again
  kFloorOrder,  ///< a part shows a place on the floor twice
  kRingHidden,  ///< the robot's body hides what the ring should show
};

/// One broken condition and by how much.
struct Failure {
  Condition condition{Condition::kSolution};
  double amount{0.0};  ///< how far from what is allowed; m, rad or a slope, as the text says
  std::string text;    ///< one line for a person, with the numbers

  friend bool operator==(const Failure&, const Failure&) = default;
};

}  // namespace teamsight::mirror
