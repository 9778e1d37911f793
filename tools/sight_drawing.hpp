// tools/sight_drawing.hpp: what a frame said, drawn on the field and on the frame itself.
#pragma once

#include <filesystem>
#include <string>

#include "geometry/field_model.hpp"
#include "tools/frame_drawing.hpp"
#include "vision/perception.hpp"

namespace teamsight::tools {

/// The field from above with the robot, its 3 sigma ellipse and the line points projected with its
/// posture: green within the inlier gate, red beyond. Balls and obstacles where their rays and feet
/// meet the floor. A lost robot is an empty field with a note.
[[nodiscard]] std::string field_drawing(const FieldModel& field,
                                        const vision::FrameObservation& seen,
                                        const std::string& title);

/// Writes both drawings as DIR/NAME.svg and DIR/NAME.png, NAME being the image file's name.
///
/// @throws std::runtime_error if the folder or a file cannot be written
void draw_sight(const std::filesystem::path& folder,
                const Shot& shot,
                const FieldModel& field,
                const vision::FrameObservation& seen);

}  // namespace teamsight::tools
