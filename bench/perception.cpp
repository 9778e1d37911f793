// bench/perception.cpp: how long a frame is looked at, by stages, beside a copy of the frame and
// the way most teams begin: every pixel through a colour table.
//
// All take turns on the same frames, so that a disturbance of the machine meets all.
#include "vision/perception.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/quantiles.hpp"
#include "process/program.hpp"
#include "sim/setup.hpp"
#include "sim/show.hpp"
#include "vision/colour_cube.hpp"
#include "vision/radial_scan.hpp"
#include "vision/ray_table.hpp"
#include "vision/resized_camera.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::bench {
namespace {

/// What this thread has computed: another busy process counts only for what it takes of the caches.
struct Clock {
  using time_point = Duration;

  static time_point now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
  }
};

constexpr std::uint32_t kLargeWidth = 1280;   // px
constexpr std::uint32_t kLargeHeight = 1024;  // px
constexpr double kCubeThreshold = 80.0;       // grey levels

Duration between(Clock::time_point start, Clock::time_point end) {
  return end - start;
}

// Class of every pixel by a table over six bits of y, u and v, as most teams do.
class ColourTable {
 public:
  ColourTable() : table_(std::size_t{1} << 18U) {
    for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = static_cast<std::uint8_t>(i % 10);
  }

  void classify(const std::vector<std::uint8_t>& yuyv, std::vector<std::uint8_t>& classes) const {
    classes.resize(yuyv.size() / 2);
    for (std::size_t i = 0; i + 3 < yuyv.size(); i += 4) {
      const std::size_t chroma = (std::size_t{yuyv[i + 1]} >> 2U) << 6U | yuyv[i + 3] >> 2U;
      classes[i / 2] = table_[(std::size_t{yuyv[i]} >> 2U) << 12U | chroma];
      classes[i / 2 + 1] = table_[(std::size_t{yuyv[i + 2]} >> 2U) << 12U | chroma];
    }
  }

 private:
  std::vector<std::uint8_t> table_;
};

// The same by a table over u and v alone, as the founding paper recommends: one look-up for two
// pixels.
class ChromaTable {
 public:
  ChromaTable() : table_(std::size_t{1} << 16U) {
    for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = static_cast<std::uint8_t>(i % 10);
  }

  void classify(const std::vector<std::uint8_t>& yuyv, std::vector<std::uint8_t>& classes) const {
    classes.resize(yuyv.size() / 2);
    for (std::size_t i = 0; i + 3 < yuyv.size(); i += 4) {
      const std::uint8_t colour = table_[std::size_t{yuyv[i + 1]} << 8U | yuyv[i + 3]];
      classes[i / 2] = colour;
      classes[i / 2 + 1] = colour;
    }
  }

 private:
  std::vector<std::uint8_t> table_;
};

enum Stage : std::uint8_t {
  kCopy,
  kTable,
  kChromaTable,
  kCube,
  kBgrCube,
  kScan,
  kLines,
  kPosture,
  kThings,
  kWhole,
  kStages
};

constexpr std::array<const char*, kStages> kNames{"copy of the frame",
                                                  "every pixel through a table",
                                                  "the same over u and v alone",
                                                  "every pixel to a cube's vertex",
                                                  "the same of BGR",
                                                  "radial lines read and judged",
                                                  "that, line points, goals",
                                                  "posture, tracked",
                                                  "balls, obstacles, sensors",
                                                  "whole perception"};

using Times = std::array<std::vector<Duration>, kStages>;

class Subject {
 public:
  Subject(const sim::Setup& setup, const vision::CameraParameters& camera)
      : camera_(camera),
        model_(camera),
        rays_(model_, camera.width_px, camera.height_px),
        lines_(camera, model_, rays_),
        colours_(camera.colours),
        scan_(lines_, camera.scan.chroma_window),
        bgr_(vision::frame_bytes(vision::PixelFormat::kBgr, camera.width_px, camera.height_px)),
        perception_(camera, setup.field),
        posture_(setup.field, perception_.head()) {}

  void look(const std::vector<std::uint8_t>& picture,
            const Pose<Field, Robot>& truth,
            Times& times) {
    auto start = Clock::now();
    copy_ = picture;
    times[kCopy].push_back(between(start, Clock::now()));
    start = Clock::now();
    table_.classify(picture, classes_);
    times[kTable].push_back(between(start, Clock::now()));
    start = Clock::now();
    chroma_table_.classify(picture, classes_);
    times[kChromaTable].push_back(between(start, Clock::now()));
    segment(frame_of(picture), times[kCube]);
    segment({bgr_, camera_.width_px, camera_.height_px, vision::PixelFormat::kBgr},
            times[kBgrCube]);
    start = Clock::now();
    scan_.read(vision::PixelReader(frame_of(picture)), colours_, lines_);
    times[kScan].push_back(between(start, Clock::now()));
    perceive(picture, truth, times);
  }

 private:
  [[nodiscard]] vision::ImageView frame_of(const std::vector<std::uint8_t>& picture) const {
    return {picture, camera_.width_px, camera_.height_px, camera_.format};
  }

  void segment(const vision::ImageView& image, std::vector<Duration>& times) {
    classes_.resize(std::size_t{image.width_px} * image.height_px);
    const auto start = Clock::now();
    cube_.segment(image, classes_);
    times.push_back(between(start, Clock::now()));
  }

  void perceive(const std::vector<std::uint8_t>& picture,
                const Pose<Field, Robot>& truth,
                Times& times) {
    vision::MotionPrior prior;
    prior.X_FR = {truth.x() + 0.03, truth.y() - 0.03, truth.theta() + 0.02};
    prior.cov = Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal();
    Clock::time_point asked;
    Clock::time_point answered;
    const auto start = Clock::now();
    const auto seen = perception_.see_with(frame_of(picture), [&](const auto& cues) {
      asked = Clock::now();
      auto result = posture_.estimate(cues.line_points, prior);
      answered = Clock::now();
      return result;
    });
    const auto end = Clock::now();
    if (!seen) return;
    times[kLines].push_back(between(start, asked));
    times[kPosture].push_back(between(asked, answered));
    times[kThings].push_back(between(answered, end));
    times[kWhole].push_back(between(start, end));
  }

  vision::CameraParameters camera_;
  vision::CameraModel model_;
  vision::RayTable rays_;
  vision::ScanLines lines_;
  vision::ColourClasses colours_;
  vision::RadialScan scan_;
  vision::ColourCube cube_{
      vision::ColourCube::thresholds(Eigen::Vector3d::Constant(kCubeThreshold))};
  std::vector<std::uint8_t> bgr_;  // any: the time does not depend on what it shows
  vision::Perception perception_;
  vision::PostureEstimator posture_;
  ColourTable table_;
  ChromaTable chroma_table_;
  std::vector<std::uint8_t> copy_;
  std::vector<std::uint8_t> classes_;
};

// Looks `repeats` times at each of `frames` pictures, a second of the match apart.
Times measure(const sim::Setup& given,
              const vision::CameraParameters& camera,
              int frames,
              int repeats) {
  sim::Setup setup = given;
  setup.camera = camera;
  sim::Eye eye = sim::make_eye(setup, 0, camera.format);
  sim::Match match(setup.parameters, setup.field);
  sim::Random random(1);
  sim::Scene scene;
  std::vector<std::uint8_t> picture;
  Subject subject(setup, camera);
  Times times;
  Times warm_up;
  for (int frame = 0; frame < frames; ++frame) {
    match.advance_to(1.0 + frame);
    sim::show(match.state(), 0, eye.bodies, scene);
    eye.renderer.draw(scene, random, picture);
    subject.look(picture, scene.X_FR, warm_up);
    for (int i = 0; i < repeats; ++i) subject.look(picture, scene.X_FR, times);
  }
  return times;
}

void report(const vision::CameraParameters& camera, const Times& times) {
  const double pixels = 1.0 * camera.width_px * camera.height_px;
  const double copy_us = quantiles_of(times[kCopy]).median_us;
  fmt::print(stderr,
             "{}x{}\n{:30} {} {:>9} {:>8}\n",
             camera.width_px,
             camera.height_px,
             "",
             table_head(),
             "ns/pixel",
             "/ copy");
  for (std::size_t stage = 0; stage < kStages; ++stage) {
    const Quantiles q = quantiles_of(times[stage]);
    fmt::print(
        "{{\"bench\":\"perception\",\"width_px\":{},\"height_px\":{},\"stage\":\"{}\",{},"
        "\"ns_per_pixel\":{:.3f},\"over_copy\":{:.2f}}}\n",
        camera.width_px,
        camera.height_px,
        kNames[stage],
        json_members(q),
        1e3 * q.median_us / pixels,
        q.median_us / copy_us);
    fmt::print(stderr,
               "{:30} {} {:>9.3f} {:>8.2f}\n",
               kNames[stage],
               table_columns(q),
               1e3 * q.median_us / pixels,
               q.median_us / copy_us);
  }
}

int run(int argc, const char* const* argv) {
  std::string match;
  int frames = 10;
  int repeats = 30;
  std::uint32_t width_px = 0;
  CLI::App app("Measures how long a frame is looked at.");
  app.add_option("--match", match, "match file (config/matches)")->required();
  app.add_option("--frames", frames)->capture_default_str()->check(CLI::PositiveNumber);
  app.add_option("--repeats", repeats, "looks at each")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--width", width_px, "only of pictures this wide, px");
  if (const std::optional<int> done = process::parse_command_line(app, argc, argv)) {
    return *done;
  }
  const sim::Setup setup = sim::load_setup(match, {}, {});
  for (const auto& camera :
       {setup.camera, vision::resized(setup.camera, kLargeWidth, kLargeHeight)}) {
    if (width_px != 0 && width_px != camera.width_px) continue;
    report(camera, measure(setup, camera, frames, repeats));
  }
  return process::kDone;
}

}  // namespace
}  // namespace teamsight::bench

int main(int argc, char** argv) {
  return teamsight::process::run_program("bench-perception",
                                         [&] { return teamsight::bench::run(argc, argv); });
}
