// settings/colour_cube_part.cpp: see settings/colour_cube_part.hpp.
#include "settings/colour_cube_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <Eigen/Core>
#include <Eigen/LU>

#include "settings/camera_names.hpp"

namespace teamsight::settings {

namespace {

using config::CameraFile;
using vision::ColourClass;
using Cube = CameraFile::Colours::Cube;

constexpr double kBrightest = 255.0;   // grey levels
constexpr double kLeastVolume = 1e-3;  // that three unit normals span

/// In the order of vision::CubeParameters.
constexpr std::array kVertices{ColourClass::kBlack,
                               ColourClass::kRed,
                               ColourClass::kGreen,
                               ColourClass::kYellow,
                               ColourClass::kBlue,
                               ColourClass::kMagenta,
                               ColourClass::kCyan,
                               ColourClass::kWhite};

vision::CubePlane plane_of(const TextFile& text, const std::string& axis, const Cube::Plane& file) {
  const std::string key = "colours.cube." + axis;
  double least = 0.0;
  double most = 0.0;
  for (const double weight : {file.red(), file.green(), file.blue()}) {
    least += kBrightest * std::min(0.0, weight);
    most += kBrightest * std::max(0.0, weight);
  }
  if (least == most) throw text.error(key, "no weight", "one of red, green or blue");
  if (file.threshold() <= least || file.threshold() >= most) {
    throw text.error(key + ".threshold",
                     text_of(file.threshold()),
                     "more than " + text_of(least) + " and less than " + text_of(most) +
                         ", which its weights reach");
  }
  return {file.red(), file.green(), file.blue(), file.threshold()};
}

Eigen::RowVector3d normal_of(const vision::CubePlane& plane) {
  return Eigen::RowVector3d(plane.red, plane.green, plane.blue).normalized();
}

// Else two vertices are one, or some can never be nearest.
void check_meet(const TextFile& text, const std::array<vision::CubePlane, 3>& planes) {
  Eigen::Matrix3d normals;
  normals << normal_of(planes[0]), normal_of(planes[1]), normal_of(planes[2]);
  if (std::abs(normals.determinant()) >= kLeastVolume) return;
  throw text.error(
      "colours.cube", "planes that do not meet in one point", "weights that are independent");
}

std::size_t index_of(const TextFile& text, const std::string& key, const Cube::Vertex& file) {
  const auto* place = std::ranges::find(kVertices, class_of(file.at()));
  if (place != kVertices.end()) return static_cast<std::size_t>(place - kVertices.begin());
  throw text.error(key + ".at",
                   CameraFile::Colours::Class_Name(file.at()),
                   "one of the cube's: BLACK, RED, GREEN, YELLOW, BLUE, MAGENTA, CYAN, WHITE");
}

std::array<ColourClass, 8> classes_of(const TextFile& text, const Cube& file) {
  std::array<ColourClass, 8> classes = kVertices;
  std::array<bool, 8> is_given{};
  for (int i = 0; i < file.vertex_size(); ++i) {
    const std::string key = "colours.cube." + key_of("vertex", i);
    const std::size_t vertex = index_of(text, key, file.vertex(i));
    if (is_given[vertex]) {
      throw text.error(
          key + ".at", CameraFile::Colours::Class_Name(file.vertex(i).at()), "each vertex once");
    }
    is_given[vertex] = true;
    classes[vertex] =
        file.vertex(i).has_class_() ? class_of(file.vertex(i).class_()) : ColourClass::kNone;
  }
  if (std::ranges::find(classes, ColourClass::kGreen) == classes.end()) {
    throw text.error("colours.cube.vertex", "none of class GREEN", "one that shows the carpet");
  }
  return classes;
}

void write_plane(const vision::CubePlane& plane, Cube::Plane& out) {
  out.set_red(plane.red);
  out.set_green(plane.green);
  out.set_blue(plane.blue);
  out.set_threshold(plane.threshold);
}

}  // namespace

vision::CubeParameters cube_of(const TextFile& text, const Cube& file) {
  vision::CubeParameters cube;
  cube.planes = {plane_of(text, "red", file.red()),
                 plane_of(text, "green", file.green()),
                 plane_of(text, "blue", file.blue())};
  check_meet(text, cube.planes);
  cube.classes = classes_of(text, file);
  return cube;
}

void write_cube(const vision::CubeParameters& cube, Cube& out) {
  write_plane(cube.planes[0], *out.mutable_red());
  write_plane(cube.planes[1], *out.mutable_green());
  write_plane(cube.planes[2], *out.mutable_blue());
  for (std::size_t i = 0; i < kVertices.size(); ++i) {
    if (cube.classes[i] == kVertices[i]) continue;
    auto& vertex = *out.add_vertex();
    vertex.set_at(file_class_of(kVertices[i]).value());
    if (const auto colour = file_class_of(cube.classes[i])) vertex.set_class_(*colour);
  }
}

}  // namespace teamsight::settings
