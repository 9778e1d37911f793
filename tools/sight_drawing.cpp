// tools/sight_drawing.cpp: an SVG of the field and a PNG of the frame.
#include "tools/sight_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "tools/picture.hpp"
#include "vision/camera_model.hpp"

namespace teamsight::tools {

namespace {

using vision::FrameObservation;

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Collects SVG elements in metres of F; one group flips y, so that y grows upwards.
class FieldCanvas {
 public:
  FieldCanvas(const FieldModel& field, const std::string& title) {
    const double half_x = 0.5 * field.length + field.surround;
    const double half_y = 0.5 * field.width + field.surround;
    constexpr double kScale = 100.0;  // px per metre
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"{2:.3f} {3:.3f} {4:.3f} {5:.3f}\">\n<title>{6}</title>\n",
        2.0 * half_x * kScale,
        2.0 * half_y * kScale + 40.0,
        field.centre.x - half_x,
        -field.centre.y - half_y - 0.4,
        2.0 * half_x,
        2.0 * half_y + 0.4,
        title);
    text_ += fmt::format(
        "<text x=\"{:.3f}\" y=\"{:.3f}\" font-size=\"0.22\" font-family=\"sans-serif\">{}</text>\n",
        field.centre.x - half_x + 0.1,
        -field.centre.y - half_y - 0.12,
        title);
    text_ += "<g transform=\"scale(1,-1)\">\n";
    text_ += fmt::format(
        "<rect x=\"{:.3f}\" y=\"{:.3f}\" width=\"{:.3f}\" height=\"{:.3f}\" fill=\"#3c6e3c\"/>\n",
        field.centre.x - half_x,
        field.centre.y - half_y,
        2.0 * half_x,
        2.0 * half_y);
  }

  void line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::string_view style) {
    text_ += fmt::format("<line x1=\"{:.4f}\" y1=\"{:.4f}\" x2=\"{:.4f}\" y2=\"{:.4f}\" {}/>\n",
                         a.x(),
                         a.y(),
                         b.x(),
                         b.y(),
                         style);
  }

  void circle(const Eigen::Vector2d& middle, double radius, std::string_view style) {
    text_ += fmt::format("<circle cx=\"{:.4f}\" cy=\"{:.4f}\" r=\"{:.4f}\" {}/>\n",
                         middle.x(),
                         middle.y(),
                         radius,
                         style);
  }

  void arc(const FieldArc& arc, std::string_view style) {
    constexpr int kPieces = 72;
    std::string points;
    for (int i = 0; i <= kPieces; ++i) {
      const double direction = arc.start + arc.sweep * i / kPieces;
      points += fmt::format("{:.4f},{:.4f} ",
                            arc.centre.x + arc.radius * std::cos(direction),
                            arc.centre.y + arc.radius * std::sin(direction));
    }
    text_ += fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", points, style);
  }

  void ellipse(const Eigen::Vector2d& middle, const Eigen::Matrix2d& cov, std::string_view style) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(cov);
    const Eigen::Vector2d axes = 3.0 * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    const Eigen::Vector2d longest = eigen.eigenvectors().col(1);
    text_ += fmt::format(
        "<ellipse rx=\"{:.4f}\" ry=\"{:.4f}\" transform=\"translate({:.4f},{:.4f}) "
        "rotate({:.2f})\" {}/>\n",
        axes(1),
        axes(0),
        middle.x(),
        middle.y(),
        kDegrees * std::atan2(longest.y(), longest.x()),
        style);
  }

  [[nodiscard]] std::string finished() const { return text_ + "</g>\n</svg>\n"; }

 private:
  std::string text_;
};

void draw_paint(FieldCanvas& canvas, const FieldModel& field) {
  const std::string paint =
      fmt::format("stroke=\"#ffffff\" stroke-width=\"{:.4f}\"", field.line_width);
  for (const FieldLine& line : field.lines) {
    canvas.line(line.from.vector(), line.to.vector(), paint);
  }
  for (const FieldArc& arc : field.arcs) canvas.arc(arc, paint);
  for (const FieldSpot& spot : field.spots) {
    canvas.circle(spot.centre.vector(), spot.radius, "fill=\"#ffffff\"");
  }
}

void draw_robot(FieldCanvas& canvas, const PostureEstimate& posture) {
  const Eigen::Vector2d p = posture.X_FR.origin().vector();
  const Eigen::Vector2d ahead = posture.X_FR.rotation().col(0);
  canvas.circle(p, 0.25, "fill=\"#222222\" fill-opacity=\"0.6\"");
  canvas.line(p, p + 0.5 * ahead, "stroke=\"#ffd000\" stroke-width=\"0.04\"");
  canvas.ellipse(p,
                 posture.cov.topLeftCorner<2, 2>(),
                 "fill=\"none\" stroke=\"#ffd000\" stroke-width=\"0.01\"");
}

void draw_line_points(FieldCanvas& canvas, const FrameObservation& seen) {
  for (std::size_t i = 0; i < seen.line_points.size() && i < seen.line_fits.size(); ++i) {
    const Point<Field> p = seen.posture.X_FR * seen.line_points[i].p_R;
    const bool fits = seen.line_fits[i];
    canvas.circle(p.vector(), 0.02, fits ? "fill=\"#00a000\"" : "fill=\"#e00000\"");
  }
}

void draw_things(FieldCanvas& canvas, const FrameObservation& seen) {
  constexpr double kBallHeight = 0.11;
  for (const BallRay& ball : seen.balls) {
    const auto p_RB = vision::meet_plane(ball.ray_R, kBallHeight);
    if (!p_RB) continue;
    canvas.circle((seen.posture.X_FR * *p_RB).vector(), 0.11, "fill=\"#ff8000\"");
  }
  for (const ObstacleSighting& obstacle : seen.obstacles) {
    canvas.circle((seen.posture.X_FR * obstacle.p_RO).vector(),
                  std::max(0.05, 0.5 * obstacle.width),
                  "fill=\"#000080\" fill-opacity=\"0.5\"");
  }
}

}  // namespace

std::string field_drawing(const FieldModel& field,
                          const FrameObservation& seen,
                          const std::string& title) {
  const PostureEstimate& posture = seen.posture;
  const bool is_lost = posture.status == PostureStatus::kLost;
  const std::string note =
      is_lost ? fmt::format("{}: lost, {} line points", title, posture.line_points)
              : fmt::format(
                    "{}: x {:.3f} m, y {:.3f} m, theta {:.1f} deg, {} line points, {:.0f} % "
                    "inliers",
                    title,
                    posture.X_FR.x(),
                    posture.X_FR.y(),
                    kDegrees * posture.X_FR.theta(),
                    posture.line_points,
                    100.0 * posture.inlier_ratio);
  FieldCanvas canvas(field, note);
  draw_paint(canvas, field);
  if (!is_lost) {
    draw_things(canvas, seen);
    draw_robot(canvas, posture);
    draw_line_points(canvas, seen);
  }
  return canvas.finished();
}

void draw_sight(const std::filesystem::path& folder,
                const Shot& shot,
                const FieldModel& field,
                const FrameObservation& seen) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::string name = shot.image.stem().string();
  std::ofstream svg(folder / (name + ".svg"));
  svg << field_drawing(field, seen, name);
  svg.close();
  if (!svg) throw std::runtime_error((folder / (name + ".svg")).string() + ": cannot be written");
  write_picture(folder / (name + ".png"), marked_frame(shot, seen));
}

}  // namespace teamsight::tools
