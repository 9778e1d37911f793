// tools/viewer.cpp: choosing the perception by the file's kind.
#include "tools/viewer.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

namespace teamsight::tools {

Viewer::Viewer(const vision::CameraParameters& camera,
               const FieldModel& field,
               const vision::PerceptionParameters& parameters)
    : camera_(camera),
      field_(field),
      parameters_(parameters) {}

Viewed Viewer::look(const std::filesystem::path& image, const vision::MotionPrior& prior) {
  Viewed viewed{read_image(image, camera_), nullptr, 0.0};
  auto& perception = is_raw_dump(image) ? raw_ : picture_;
  if (!perception) {
    vision::CameraParameters camera = camera_;
    camera.format = viewed.frame.format;
    perception.emplace(camera, field_, parameters_);
  }
  const auto start = std::chrono::steady_clock::now();
  const auto seen = perception->see(viewed.frame.view(), prior);
  const auto elapsed = std::chrono::steady_clock::now() - start;
  if (!seen) throw std::runtime_error(image.string() + ": not a frame of this camera");
  viewed.seen = *seen;
  viewed.time_ms = std::chrono::duration<double, std::milli>(elapsed).count();
  return viewed;
}

}  // namespace teamsight::tools
