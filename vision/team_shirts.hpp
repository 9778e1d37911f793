// vision/team_shirts.hpp: what the two teams wear.
#pragma once

#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// What the two teams wear; kNone: nobody has said.
struct TeamShirts {
  ColourClass own{ColourClass::kNone};
  ColourClass theirs{ColourClass::kNone};

  friend bool operator==(const TeamShirts&, const TeamShirts&) = default;
};

}  // namespace teamsight::vision
