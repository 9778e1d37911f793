// tools/line_views.hpp: line pixels for a calibration, from images or from lists.
#pragma once

#include <string>
#include <vector>

#include "geometry/field_model.hpp"
#include "tools/progress_line.hpp"
#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/perception.hpp"

namespace teamsight::tools {

/// The views of a calibration, in order; a vision::LineSource.
///
/// A file that ends in .txt is a list of line pixels, one "u_px v_px" a line, that stays as it is;
/// anything else is a picture or a .raw dump in which the lines are looked for. Pixels under the
/// camera's mask are left out.
class LineViews {
 public:
  /// @param camera  whose mask and size count for the lists
  /// @throws std::runtime_error naming the file: a list cannot be read or holds something else than
  ///         pixels of its image
  LineViews(std::vector<std::string> files,
            const vision::CameraParameters& camera,
            const FieldModel& field);

  /// Reads the pictures and looks for lines through this camera. Says on the terminal how far it
  /// is.
  ///
  /// @throws std::runtime_error naming the file: it cannot be read or is no frame of this camera
  [[nodiscard]] std::vector<std::vector<vision::Pixel>> operator()(
      const vision::CameraParameters& camera);

 private:
  std::vector<std::string> files_;
  FieldModel field_;
  std::vector<std::vector<vision::Pixel>> lists_;  // of each file; empty: a picture
  ProgressLine progress_;
  int looks_{0};
};

/// The pixels of the paint's middle on the floor, as a frame's line points have it; that of the
/// picture, which is squeezed outwards, lies a little farther in.
[[nodiscard]] std::vector<vision::Pixel> paint_middles(const vision::FrameObservation& seen,
                                                       const vision::CameraModel& model);

}  // namespace teamsight::tools
