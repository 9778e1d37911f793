// tools/viewer.hpp: the perception of one camera, for raw dumps and for pictures alike.
#pragma once

#include <filesystem>
#include <optional>

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
  Viewer(const vision::CameraParameters& camera,
         const FieldModel& field,
         const vision::PerceptionParameters& parameters = {});

  /// @throws std::runtime_error naming the file, if it is no frame of this camera
  [[nodiscard]] Viewed look(const std::filesystem::path& image, const vision::MotionPrior& prior);

 private:
  vision::CameraParameters camera_;
  FieldModel field_;
  vision::PerceptionParameters parameters_;
  std::optional<vision::Perception> raw_;
  std::optional<vision::Perception> picture_;
};

}  // namespace teamsight::tools
