// vision/resized_camera.hpp: the same eye with another number of pixels.
#pragma once

#include <cstdint>

#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// The same lens and mirror in front of a sensor of another number of pixels: whatever the old
/// picture shows around its middle fills the new one's width or height, whichever is tighter.
/// Mirror, mask and the sensors' windows go with it; what rings are known to in pixels stays. How
/// well a calibration knew the old sensor says nothing of the new one: that is left out.
///
/// @pre the sizes are not zero, and the new one is one that the camera's format can have
[[nodiscard]] CameraParameters resized(const CameraParameters& camera,
                                       std::uint32_t width_px,
                                       std::uint32_t height_px);

}  // namespace teamsight::vision
