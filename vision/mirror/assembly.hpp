// vision/mirror/assembly.hpp: a mirror with its camera and the robot below it.
#pragma once

#include <vector>

#include "vision/mirror/profile.hpp"

namespace teamsight::mirror {

/// An upright cylinder of the robot's body around the axis, standing on the floor.
struct BodyCylinder {
  double height{0.0};  ///< of its top over the floor; m
  double radius{0.0};  ///< m

  friend bool operator==(const BodyCylinder&, const BodyCylinder&) = default;
};

/// Mirror, pinhole and body, all on one vertical axis.
struct Assembly {
  Profile profile;
  double pinhole_height{0.0};      ///< over the floor; m
  double focal_px{0.0};            ///< image radius per tangent of the camera ray's angle; px
  std::vector<BodyCylinder> body;  ///< what hides the floor; may be empty

  friend bool operator==(const Assembly&, const Assembly&) = default;
};

}  // namespace teamsight::mirror
