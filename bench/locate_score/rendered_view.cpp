// bench/locate_score/rendered_view.cpp: drawing and reading one frame.
#include "bench/locate_score/rendered_view.hpp"

#include <cmath>

namespace teamsight::locate_score {

namespace {

constexpr std::uint32_t kNoiseSeed = 7;

sim::PictureParameters picture(double noise_sigma) {
  sim::PictureParameters parameters;
  parameters.sensor.noise_sigma = noise_sigma;
  return parameters;
}

}  // namespace

RenderedView::RenderedView(const vision::CameraParameters& true_camera,
                           const vision::CameraParameters& camera_file,
                           const FieldModel& field,
                           double pixel_noise_sigma)
    : camera_(camera_file),
      renderer_(true_camera, field, picture(pixel_noise_sigma)),
      perception_(camera_file, field),
      noise_(kNoiseSeed) {}

void RenderedView::draw(const Pose<Field, Robot>& X_FR, std::span<const Point<Field>> robots) {
  scene_.X_FR = X_FR;
  scene_.robots.clear();
  for (const Point<Field>& p_F : robots) {
    sim::SceneRobot robot;
    robot.p_F = p_F;
    scene_.robots.push_back(robot);
  }
  renderer_.draw(scene_, noise_, picture_);
}

void RenderedView::blind(const Glare& glare) {
  const bool luminance_first = camera_.format == vision::PixelFormat::kYuyv;
  for (std::uint32_t v = 0; v < camera_.height_px; ++v) {
    for (std::uint32_t u = 0; u < camera_.width_px; ++u) {
      if (std::hypot(u - glare.u_px, v - glare.v_px) > glare.radius_px) continue;
      const std::size_t at = 2 * (std::size_t{v} * camera_.width_px + u);
      picture_[at + (luminance_first ? 0 : 1)] = 255;
      picture_[at + (luminance_first ? 1 : 0)] = 128;
    }
  }
}

vision::ImageView RenderedView::image() const {
  return {picture_, camera_.width_px, camera_.height_px, camera_.format};
}

vision::Perception::Cues RenderedView::cues() {
  const auto seen = perception_.see_with(
      image(), [](const vision::Perception::Cues&) { return vision::PostureResult{}; });
  if (!seen) return {};
  return {(*seen)->line_points, (*seen)->goals};
}

}  // namespace teamsight::locate_score
