// tests/fuzz/frame_subject.cpp: eyes of every format and of even and odd sizes, and their frames.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "sim/match/random.hpp"
#include "sim/render/renderer.hpp"
#include "tests/fuzz/observation_fault.hpp"
#include "tests/fuzz/small_field.hpp"
#include "tests/fuzz/subjects.hpp"
#include "vision/perception.hpp"

namespace teamsight::fuzz {
namespace {

using vision::CameraParameters;
using vision::ColourClass;
using vision::ImageView;
using vision::PixelFormat;

constexpr std::uint8_t kFormats = 9;
const Pose<Field, Robot> kX_FR{-0.6, 0.4, 0.6};

/// The bytes of an input, one after the other; zeros behind its end.
class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t next() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }

  [[nodiscard]] bool is_over() const { return bytes_.empty(); }

 private:
  std::span<const std::uint8_t> bytes_;
};

CameraParameters camera_of(PixelFormat format, bool odd) {
  CameraParameters camera;
  camera.name = "small";
  camera.width_px = odd ? 65 : 64;
  camera.height_px = odd ? 47 : 48;
  camera.format = format;
  camera.forward = 0.5 * std::numbers::pi;
  camera.mirrored = true;
  vision::RadialTable table;
  table.centre_u_px = 31.5;
  table.centre_v_px = 23.5;
  table.mirror_height = 0.75;
  for (int radius = 3; radius <= 23; radius += 2) {
    table.rows.push_back({1.0 * radius, 1.2 * std::tan(0.05 * radius), 0.1});
  }
  camera.mirror = table;
  camera.mask.inner_radius_px = 4.0;
  camera.scan.max_distance = 4.0;
  camera.scan.rays = 90;
  camera.colours.white_min_y = 150;
  camera.colours.black_max_y = 40;
  camera.colours.samples = {{ColourClass::kGreen, 101, 94, 24},
                            {ColourClass::kBall, 61, 200, 30},
                            {ColourClass::kBlue, 203, 102, 30}};
  camera.sensors = {
      {"ball", vision::SensorKind::kBall, {}, {{{20, 10}, {45, 10}, {30, 40}}}, 0.1},
      {"lens", vision::SensorKind::kCalibration, {}, {{{30, 20}, {34, 20}, {32, 28}}}, 0.1},
      {"dark",
       vision::SensorKind::kBumper,
       {ColourClass::kBlack},
       {{{0, 0}, {63, 0}, {32, 47}}},
       0.1}};
  return camera;
}

/// A field with a ball, a robot and a person, as that camera shows it.
std::vector<std::uint8_t> picture_of(const CameraParameters& camera) {
  sim::Scene scene;
  scene.X_FR = kX_FR;
  scene.balls = {{{0.1, 0.3, 0.11}, {}, 0.11, {240, 110, 20}}};
  scene.robots = {{{0.6, -0.5}, {}, 0.25, 0.8, {40, 70, 200}}};
  scene.people = {{{-1.2, -0.6}, {36, 38, 54}, {120, 60, 60}}};
  sim::Renderer renderer(camera, small_field(), {});
  sim::Random random(1);
  std::vector<std::uint8_t> bytes;
  renderer.draw(scene, random, bytes);
  return bytes;
}

struct Eye {
  explicit Eye(const CameraParameters& parameters)
      : camera(parameters),
        perception(parameters, small_field()) {
    const ImageView empty{{}, camera.width_px, camera.height_px, camera.format};
    if (vision::has_even_size(empty.format, empty.width_px, empty.height_px)) {
      picture = picture_of(camera);
    }
  }

  CameraParameters camera;
  vision::Perception perception;
  std::vector<std::uint8_t> picture;  // empty: frames of that size cannot be
};

Eye& eye_of(std::uint8_t format, bool odd) {
  static std::map<std::pair<std::uint8_t, bool>, std::unique_ptr<Eye>> eyes;
  std::unique_ptr<Eye>& eye = eyes[{format, odd}];
  if (!eye) eye = std::make_unique<Eye>(camera_of(static_cast<PixelFormat>(format), odd));
  return *eye;
}

/// Half of the values leave things as they are.
int change_of(std::uint8_t value) {
  return value < 128 ? 0 : value - 192;
}

std::uint32_t changed(std::uint32_t size_px, std::uint8_t value) {
  return static_cast<std::uint32_t>(std::max(0, static_cast<int>(size_px) + change_of(value)));
}

std::vector<std::uint8_t> scene_of(std::uint8_t choice, const Eye& eye) {
  const std::size_t size =
      vision::frame_bytes(eye.camera.format, eye.camera.width_px, eye.camera.height_px);
  if (choice < 128 && !eye.picture.empty()) return eye.picture;
  std::vector<std::uint8_t> bytes(size, choice);
  if (choice >= 192) {
    std::mt19937 random(choice);
    std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(random()); });
  }
  return bytes;
}

/// Every `step`-th byte of a part gets a value.
void paint(Input& input, std::vector<std::uint8_t>& bytes) {
  const std::size_t place = std::size_t{input.next()} << 8U | input.next();
  const std::size_t count = std::size_t{8} * (input.next() + 1U);
  const std::uint8_t value = input.next();
  const std::size_t step = input.next() % 8U + 1U;
  if (bytes.empty()) return;
  const std::size_t first = place * bytes.size() / 65536;
  for (std::size_t i = first; i < std::min(bytes.size(), first + count); i += step)
    bytes[i] = value;
}

}  // namespace

std::string fault_of_frame(std::span<const std::uint8_t> given) {
  Input input(given);
  const std::uint8_t format = input.next() % kFormats;
  Eye& eye = eye_of(format, input.next() % 4 == 3);
  std::vector<std::uint8_t> bytes = scene_of(input.next(), eye);
  ImageView view;
  const std::uint8_t claimed = input.next();
  view.format = claimed < 192 ? eye.camera.format : static_cast<PixelFormat>(claimed % kFormats);
  view.width_px = changed(eye.camera.width_px, input.next());
  view.height_px = changed(eye.camera.height_px, input.next());
  // Cut short, or with rows that are longer than they should be.
  const int longer = change_of(input.next());
  const auto rows = static_cast<int>(eye.camera.height_px);
  const int size = static_cast<int>(bytes.size()) + (longer > 0 ? longer * rows : longer);
  bytes.resize(static_cast<std::size_t>(std::max(0, size)));
  while (!input.is_over()) paint(input, bytes);
  view.bytes = bytes;
  // Without a prior the whole field is searched, which takes most of the time: in few inputs.
  vision::MotionPrior prior;
  if (claimed % 8 != 0) prior.X_FR = kX_FR;

  const auto seen = eye.perception.see(view, prior);

  const bool is_ours = view.format == eye.camera.format && view.width_px == eye.camera.width_px &&
                       view.height_px == eye.camera.height_px && vision::is_whole(view);
  if (seen.has_value() != is_ours) return is_ours ? "a frame was refused" : "no frame was taken";
  return is_ours ? fault_of(**seen) : "";
}

}  // namespace teamsight::fuzz
