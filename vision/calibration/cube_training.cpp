// vision/calibration/cube_training.cpp: vertices for classes, then a plane for each of three bits.
#include "vision/calibration/cube_training.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include <Eigen/Core>

#include "geometry/expect.hpp"
#include "vision/calibration/trait_training.hpp"
#include "vision/camera_model.hpp"
#include "vision/colour_classes.hpp"
#include "vision/light_gains.hpp"
#include "vision/pixel_reader.hpp"
#include "vision/polygon.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kOfEachClass = 500;  // pixels that teach
constexpr std::size_t kClasses = 10;

/// What each vertex shows if nothing else is said, in the order of CubeParameters.
constexpr std::array kOwnColours{ColourClass::kBlack,
                                 ColourClass::kRed,
                                 ColourClass::kGreen,
                                 ColourClass::kYellow,
                                 ColourClass::kBlue,
                                 ColourClass::kMagenta,
                                 ColourClass::kCyan,
                                 ColourClass::kWhite};

/// Pixels of one class, in red, green and blue, and the vertex where they belong.
struct Lesson {
  std::vector<Eigen::Vector3d> pixels;
  std::size_t vertex{0};
};

// In turn from all places of the class, and from all over each.
std::vector<Eigen::Vector3d> pixels_of(ColourClass colour,
                                       const std::vector<LabelledColours>& places) {
  std::vector<const LabelledColours*> of_class;
  for (const LabelledColours& place : places) {
    TEAMSIGHT_EXPECT(!place.pixels.empty());
    if (place.colour == colour) of_class.push_back(&place);
  }
  std::vector<Eigen::Vector3d> pixels;
  if (of_class.empty()) return pixels;
  const std::size_t of_each = std::max<std::size_t>(1, kOfEachClass / of_class.size());
  for (std::size_t i = 0; i < kOfEachClass; ++i) {
    const std::vector<SampledColour>& place = of_class[i % of_class.size()]->pixels;
    const std::size_t turn = i / of_class.size() % of_each;
    const SampledColour& pixel = place[turn * place.size() / of_each];
    pixels.push_back(rgb_of(pixel.y, pixel.u, pixel.v));
  }
  return pixels;
}

double hue_of(const Eigen::Vector3d& rgb) {
  const Eigen::Vector3d yuv = yuv_from_rgb() * rgb;
  return std::atan2(yuv(2), yuv(1));
}

// The free vertex that is neither black nor white and most like these pixels.
std::optional<std::size_t> vertex_like(const std::vector<Eigen::Vector3d>& pixels,
                                       const std::array<bool, 8>& is_taken) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& pixel : pixels) sum += pixel;
  const double hue = hue_of(sum);
  std::optional<std::size_t> best;
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t vertex = 1; vertex + 1 < kOwnColours.size(); ++vertex) {
    if (is_taken[vertex]) continue;
    const Eigen::Vector3d pure((vertex & 1U) != 0 ? 1.0 : 0.0,
                               (vertex & 2U) != 0 ? 1.0 : 0.0,
                               (vertex & 4U) != 0 ? 1.0 : 0.0);
    const double apart = std::abs(std::remainder(hue_of(pure) - hue, 2.0 * std::numbers::pi));
    if (apart >= nearest) continue;
    nearest = apart;
    best = vertex;
  }
  return best;
}

// One for each vertex's own colour that was labelled, and one for the ball.
std::optional<std::vector<Lesson>> lessons_of(const std::vector<LabelledColours>& places) {
  std::vector<Lesson> lessons;
  std::array<bool, 8> is_taken{};
  for (std::size_t vertex = 0; vertex < kOwnColours.size(); ++vertex) {
    std::vector<Eigen::Vector3d> pixels = pixels_of(kOwnColours[vertex], places);
    is_taken[vertex] = !pixels.empty();
    if (is_taken[vertex]) lessons.push_back({std::move(pixels), vertex});
  }
  if (!is_taken.front() || !is_taken[2] || !is_taken.back()) return std::nullopt;
  std::vector<Eigen::Vector3d> ball = pixels_of(ColourClass::kBall, places);
  if (ball.empty()) return lessons;
  const auto vertex = vertex_like(ball, is_taken);
  if (!vertex) return std::nullopt;
  lessons.push_back({std::move(ball), *vertex});
  return lessons;
}

// Between the vertices with and without this bit; the largest weight is 1.
CubePlane plane_between(const std::vector<Lesson>& lessons, unsigned bit) {
  const auto count = static_cast<Eigen::Index>(lessons.size() * kOfEachClass);
  Eigen::MatrixXd colours(count, 3);
  Eigen::VectorXd is_bright(count);
  Eigen::Index row = 0;
  for (const Lesson& lesson : lessons) {
    for (const Eigen::Vector3d& pixel : lesson.pixels) {
      colours.row(row) = pixel.transpose();
      is_bright(row++) = (lesson.vertex >> bit & 1U) != 0 ? 1.0 : 0.0;
    }
  }
  const auto weights = fit_weights(colours, is_bright, {});
  TEAMSIGHT_EXPECT(weights.has_value());  // black and white are on both sides
  const double scale = weights->head<3>().cwiseAbs().maxCoeff();
  return {
      (*weights)(0) / scale, (*weights)(1) / scale, (*weights)(2) / scale, -(*weights)(3) / scale};
}

}  // namespace

std::optional<CubeParameters> train_cube(const std::vector<LabelledColours>& places) {
  const auto lessons = lessons_of(places);
  if (!lessons) return std::nullopt;
  CubeParameters cube;
  for (unsigned bit = 0; bit < cube.planes.size(); ++bit) {
    cube.planes[bit] = plane_between(*lessons, bit);
  }
  for (const Lesson& lesson : *lessons) {
    cube.classes[lesson.vertex] = kOwnColours[lesson.vertex];
  }
  const bool has_ball =
      std::ranges::find(places, ColourClass::kBall, &LabelledColours::colour) != places.end();
  if (has_ball) cube.classes[lessons->back().vertex] = ColourClass::kBall;
  return cube;
}

std::vector<LabelledColours> labelled_by_classes(const ImageView& image,
                                                 const CameraParameters& camera) {
  const PixelReader pixels(image);
  const ColourClasses classes(camera.colours);
  const Pixel centre = CameraModel(camera).centre();
  std::array<LabelledColours, kClasses> places;
  for (std::size_t pixel = 0; pixel < std::size_t{image.width_px} * image.height_px; ++pixel) {
    const std::size_t row = pixel / image.width_px;
    const Corner place{static_cast<double>(pixel % image.width_px), static_cast<double>(row)};
    const double radius = std::hypot(place.u - centre.u, place.v - centre.v);
    if (radius < camera.mask.inner_radius_px || radius > camera.mask.outer_radius_px) continue;
    if (is_hidden(camera.mask, place)) continue;
    const Chroma chroma = pixels.chroma(pixel);
    const std::uint8_t y = pixels.luminance(pixel);
    const auto known = static_cast<std::size_t>(classes.of(y, chroma));
    places.at(known).pixels.push_back({y, chroma.u, chroma.v});
  }
  std::vector<LabelledColours> found;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places.at(i).pixels.empty()) continue;
    found.push_back({static_cast<ColourClass>(i), std::move(places.at(i).pixels)});
  }
  return found;
}

}  // namespace teamsight::vision
