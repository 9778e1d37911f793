// tools/line_views.hpp: line pixels for a calibration, from images or from lists.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/field_model.hpp"
#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/perception.hpp"

namespace teamsight::tools {

/// Reads the views of a calibration, in order.
///
/// A file that ends in .txt is a list of line pixels, one "u_px v_px" a line; anything else is a
/// picture or a .raw dump in which the lines are looked for. Pixels under the camera's mask are
/// left out.
///
/// @throws std::runtime_error naming the file: it cannot be read, is no frame of this camera, or a
///         list holds something else than pixels of its image
[[nodiscard]] std::vector<std::vector<vision::Pixel>> read_line_views(
    const std::vector<std::string>& files,
    const vision::CameraParameters& camera,
    const FieldModel& field);

/// The pixels of the paint's middle on the floor, as a frame's line points have it; that of the
/// picture, which is squeezed outwards, lies a little farther in.
[[nodiscard]] std::vector<vision::Pixel> paint_middles(const vision::FrameObservation& seen,
                                                       const vision::CameraModel& model);

}  // namespace teamsight::tools
