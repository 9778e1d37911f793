// bench/locate_score/rendered_view.hpp: pictures of the simulator, and the line points in them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/field_model.hpp"
#include "geometry/pose.hpp"
#include "sim/match/random.hpp"
#include "sim/render/renderer.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/perception.hpp"

namespace teamsight::locate_score {

/// A spot of light that blinds the camera.
struct Glare {
  double u_px{0.0};
  double v_px{0.0};
  double radius_px{0.0};
};

/// Renders with one camera and perceives with another: what the robot has, and what its file says.
class RenderedView {
 public:
  /// @param true_camera  what the picture is drawn with
  /// @param camera_file  what it is read with; the same size and format, YUYV or UYVY
  RenderedView(const vision::CameraParameters& true_camera,
               const vision::CameraParameters& camera_file,
               const FieldModel& field,
               double pixel_noise_sigma);

  /// Draws one frame. @param robots  the axes of robots that stand around
  void draw(const Pose<Field, Robot>& X_FR, std::span<const Point<Field>> robots);

  /// Blinds the camera in the frame drawn last.
  void blind(const Glare& glare);

  /// Line points and goals of the frame drawn last; valid until the next call.
  [[nodiscard]] vision::Perception::Cues cues();

  [[nodiscard]] std::span<const vision::LinePoint> line_points() { return cues().line_points; }

  [[nodiscard]] vision::ImageView image() const;

  [[nodiscard]] const vision::HeadTilt& head() const { return perception_.head(); }

 private:
  vision::CameraParameters camera_;
  sim::Renderer renderer_;
  vision::Perception perception_;
  sim::Random noise_;
  sim::Scene scene_;
  std::vector<std::uint8_t> picture_;
};

}  // namespace teamsight::locate_score
