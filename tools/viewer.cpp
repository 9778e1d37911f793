// tools/viewer.cpp: choosing the perception by the file's kind.
#include "tools/viewer.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "vision/light_adaptation.hpp"

namespace teamsight::tools {

namespace {

constexpr double kLookPeriod = 1e3;  // s that one look at the light speaks for

// A picture stands for itself: its light is that of no other.
void adapt(vision::Perception& perception, const vision::ImageView& frame) {
  vision::LightAdaptation light(perception.light());
  light.take(perception.field_colours(frame), kLookPeriod);
  perception.adapt(light.state().gains);
}

}  // namespace

Viewer::Viewer(const vision::CameraParameters& camera,
               const FieldModel& field,
               const vision::PerceptionParameters& parameters,
               bool follows_light)
    : camera_(camera),
      field_(field),
      parameters_(parameters),
      follows_light_(follows_light) {}

Viewed Viewer::look(const std::filesystem::path& image, const vision::MotionPrior& prior) {
  return look(read_image(image, camera_), image.string(), prior);
}

Viewed Viewer::look(ImageFile frame, const std::string& name, const vision::MotionPrior& prior) {
  Viewed viewed{std::move(frame), nullptr, 0.0};
  auto& perception = viewed.frame.format == camera_.format ? own_ : picture_;
  if (!perception) {
    vision::CameraParameters camera = camera_;
    camera.format = viewed.frame.format;
    perception.emplace(camera, field_, parameters_);
  }
  if (follows_light_) adapt(*perception, viewed.frame.view());
  const auto start = std::chrono::steady_clock::now();
  const auto seen = perception->see(viewed.frame.view(), prior);
  const auto elapsed = std::chrono::steady_clock::now() - start;
  if (!seen) throw std::runtime_error(name + ": not a frame of this camera");
  viewed.seen = *seen;
  viewed.time_ms = std::chrono::duration<double, std::milli>(elapsed).count();
  return viewed;
}

}  // namespace teamsight::tools
