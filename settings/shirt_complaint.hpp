// settings/shirt_complaint.hpp: shirts that the camera's colours cannot tell, in words.
#pragma once

#include <string>

#include "vision/camera_parameters.hpp"
#include "vision/team_shirts.hpp"

namespace teamsight::settings {

/// What the operator reads at the start when the camera file has no class for a colour that the
/// team file says is worn: nobody is known by it then.
///
/// @return empty: there is nothing to complain of
[[nodiscard]] std::string shirt_complaint(const vision::TeamShirts& shirts,
                                          const vision::ColourParameters& colours);

}  // namespace teamsight::settings
