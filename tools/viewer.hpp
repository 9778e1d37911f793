// tools/viewer.hpp: the perception of one camera, for raw dumps and for pictures alike.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/field_model.hpp"
#include "tools/image_file.hpp"
#include "vision/perception.hpp"

namespace teamsight::tools {

/// What a viewer saw in one file.
struct Viewed {
  ImageFile frame;
  const vision::FrameObservation* seen{nullptr};  ///< until the next call
  double time_ms{0.0};  ///< of the perception alone, without reading the file
};

/// Looks at image files through a camera file. Keeps one Perception for the camera's own pixel
/// format and one for pictures, each made when first needed.
class Viewer {
 public:
  /// @param follows_light  take each picture for itself in its own light, as an agent would after
  ///                       some seconds of it; where the camera file names none, nothing changes
  Viewer(const vision::CameraParameters& camera,
         const FieldModel& field,
         const vision::PerceptionParameters& parameters = {},
         bool follows_light = true);

  /// @throws std::runtime_error naming the file, if it is no frame of this camera
  [[nodiscard]] Viewed look(const std::filesystem::path& image, const vision::MotionPrior& prior);

  /// The same of a frame that has been read.
  ///
  /// @param name  of the frame, for messages
  [[nodiscard]] Viewed look(ImageFile frame,
                            const std::string& name,
                            const vision::MotionPrior& prior);

  [[nodiscard]] const vision::CameraParameters& camera() const { return camera_; }

 private:
  vision::CameraParameters camera_;
  FieldModel field_;
  vision::PerceptionParameters parameters_;
  bool follows_light_;
  std::optional<vision::Perception> own_;
  std::optional<vision::Perception> picture_;
};

}  // namespace teamsight::tools
