// tools/line_views.cpp: detection through the Viewer, or reading of numbers.
#include "tools/line_views.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "tools/viewer.hpp"
#include "vision/polygon.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::tools {

namespace {

namespace fs = std::filesystem;

bool is_list(const fs::path& path) {
  return path.extension() == ".txt";
}

std::runtime_error bad_line(const fs::path& path, int line, const std::string& text) {
  return std::runtime_error(path.string() + ":" + std::to_string(line) + ": found \"" + text +
                            "\", expected the column and row of a pixel in the image");
}

// Two numbers and nothing else.
std::optional<vision::Pixel> pixel_in(const std::string& text) {
  std::istringstream in(text);
  vision::Pixel pixel;
  std::string rest;
  if (!(in >> pixel.u >> pixel.v) || (in >> rest)) return std::nullopt;
  return pixel;
}

bool is_in_image(const vision::Pixel& pixel, const vision::CameraParameters& camera) {
  return pixel.u >= 0.0 && pixel.v >= 0.0 && pixel.u <= camera.width_px - 1.0 &&
         pixel.v <= camera.height_px - 1.0;
}

bool is_hidden(const vision::Pixel& pixel, const vision::Pixel& centre, const vision::Mask& mask) {
  const double du = pixel.u - centre.u;
  const double dv = pixel.v - centre.v;
  const double radius = std::hypot(du, dv);
  return radius < mask.inner_radius_px || radius > mask.outer_radius_px ||
         vision::is_masked(mask, std::atan2(-dv, du)) ||
         vision::is_hidden(mask, {pixel.u, pixel.v});
}

std::vector<vision::Pixel> read_list(const fs::path& path, const vision::CameraParameters& camera) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path.string() + ": found no readable file, expected a list");
  const vision::CameraModel model(camera);
  std::vector<vision::Pixel> pixels;
  std::string text;
  for (int line = 1; std::getline(file, text); ++line) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto pixel = pixel_in(text);
    if (!pixel || !is_in_image(*pixel, camera)) throw bad_line(path, line, text);
    if (!is_hidden(*pixel, model.centre(), camera.mask)) pixels.push_back(*pixel);
  }
  return pixels;
}

}  // namespace

std::vector<vision::Pixel> paint_middles(const vision::FrameObservation& seen,
                                         const vision::CameraModel& model) {
  std::vector<vision::Pixel> pixels;
  for (const vision::LinePoint& point : seen.line_points) {
    const auto pixel = model.project({point.p_R.x, point.p_R.y, 0.0});
    if (pixel) pixels.push_back(*pixel);
  }
  return pixels;
}

LineViews::LineViews(std::vector<std::string> files,
                     const vision::CameraParameters& camera,
                     const FieldModel& field)
    : files_(std::move(files)),
      field_(field),
      lists_(files_.size()) {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (is_list(files_[i])) lists_[i] = read_list(files_[i], camera);
  }
}

std::vector<std::vector<vision::Pixel>> LineViews::operator()(
    const vision::CameraParameters& camera) {
  Viewer viewer(camera, field_);
  const vision::CameraModel model(camera);
  std::vector<std::vector<vision::Pixel>> views = lists_;
  const std::string look = fmt::format("look {}: ", ++looks_);
  for (std::size_t i = 0; i < files_.size(); ++i) {
    progress_.say(fmt::format("{}lines in view {} of {}", look, i + 1, files_.size()));
    if (is_list(files_[i])) continue;
    views[i] = paint_middles(*viewer.look(files_[i], {}).seen, model);
  }
  progress_.say(
      fmt::format("{}fitting the camera and the places of {} views", look, files_.size()));
  return views;
}

}  // namespace teamsight::tools
