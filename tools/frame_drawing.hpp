// tools/frame_drawing.hpp: what a frame said, marked on the frame itself; its colour classes.
#pragma once

#include <filesystem>
#include <span>

#include "tools/detection_score.hpp"
#include "tools/image_file.hpp"
#include "tools/picture.hpp"
#include "vision/colour_classes.hpp"
#include "vision/perception.hpp"

namespace teamsight::tools {

/// A frame, the file it came from, and the windows of its camera's virtual sensors.
struct Shot {
  std::filesystem::path image;
  const ImageFile& frame;
  std::span<const vision::SensorWindows> sensors;
};

/// The frame twice as large, with line points (green inliers of the posture, else red), balls
/// (magenta, with metres to the floor and by their size), feet of robots (cyan) and of legs (thin,
/// yellow), and sensor windows: red when the sensor triggers, else blue.
[[nodiscard]] Picture marked_frame(const Shot& shot, const vision::FrameObservation& seen);

/// As marked_frame, without line points, and with what the labels say of it: a green ring where a
/// robot's, ball's or person's label was found, a red one where it was missed, a grey one where it
/// does not count; an orange square around each false alarm.
[[nodiscard]] Picture judged_frame(const Shot& shot,
                                   const vision::FrameObservation& seen,
                                   const ImageLabels& labels);

/// The frame, and beside it each pixel in the colour of its own class: the ball's orange, grey
/// where it has none.
[[nodiscard]] Picture class_picture(const ImageFile& frame, const vision::ColourClasses& colours);

}  // namespace teamsight::tools
