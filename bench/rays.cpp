// bench/rays.cpp: how long the table of a mirror's rays takes, beside the bare rays in it.
//
// The two take turns, so that a disturbance of the machine meets both.
#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/quantiles.hpp"
#include "process/program.hpp"
#include "settings/load.hpp"
#include "vision/camera_model.hpp"
#include "vision/ray_table.hpp"

namespace teamsight::bench {
namespace {

using Clock = std::chrono::steady_clock;

struct Options {
  std::string camera;
  std::uint32_t width_px{1280};
  std::uint32_t height_px{1024};
  int rounds{9};
};

struct Times {
  std::vector<Duration> table;
  std::vector<Duration> bare;
};

Duration since(Clock::time_point start) {
  return std::chrono::duration_cast<Duration>(Clock::now() - start);
}

// The same mirror behind a sensor of another size, which it fills as far as before.
vision::CameraParameters resized(vision::CameraParameters camera, const Options& options) {
  auto* mirror = std::get_if<vision::ProfileMirror>(&camera.mirror);
  if (mirror == nullptr) {
    throw std::runtime_error(options.camera + ": mirror: found radial_table, expected profile");
  }
  const double scale = static_cast<double>(options.height_px) / camera.height_px;
  mirror->focal_x_px *= scale;
  mirror->focal_y_px *= scale;
  mirror->centre_u_px = 0.5 * (options.width_px - 1.0);
  mirror->centre_v_px = 0.5 * (options.height_px - 1.0);
  camera.width_px = options.width_px;
  camera.height_px = options.height_px;
  return camera;
}

// The height of the last ray, so that none is left out.
double trace_all(const vision::CameraModel& model, const Options& options) {
  double height = 0.0;
  for (std::uint32_t v = 0; v < options.height_px; ++v) {
    for (std::uint32_t u = 0; u < options.width_px; ++u) {
      const auto ray = model.ray({static_cast<double>(u), static_cast<double>(v)});
      if (ray) height += ray->direction.z();
    }
  }
  return height;
}

Times measure(const vision::CameraModel& model, const Options& options) {
  Times times;
  volatile double sink = 0.0;  // the compiler must not find out that nobody looks
  for (int round = 0; round < options.rounds; ++round) {
    auto start = Clock::now();
    const vision::RayTable table(model, options.width_px, options.height_px);
    times.table.push_back(since(start));
    start = Clock::now();
    sink = sink + trace_all(model, options);
    times.bare.push_back(since(start));
  }
  return times;
}

void report(const std::string& name, const std::vector<Duration>& times, double bare_us) {
  const Quantiles quantiles = quantiles_of(times);
  fmt::print("{{\"bench\":\"rays\",\"way\":\"{}\",{},\"over_bare\":{:.2f}}}\n",
             name,
             json_members(quantiles),
             quantiles.median_us / bare_us);
  fmt::print(
      stderr, "{:16} {} {:>8.2f}\n", name, table_columns(quantiles), quantiles.median_us / bare_us);
}

int run(int argc, const char* const* argv) {
  Options options;
  CLI::App app("Measures how long the table of a camera's rays takes.");
  app.add_option("--camera", options.camera, "camera file with a profile mirror")->required();
  app.add_option("--width", options.width_px)->capture_default_str()->check(CLI::Range(16, 8192));
  app.add_option("--height", options.height_px)->capture_default_str()->check(CLI::Range(16, 8192));
  app.add_option("--rounds", options.rounds)->capture_default_str()->check(CLI::PositiveNumber);
  if (const std::optional<int> done = process::parse_command_line(app, argc, argv)) {
    return *done;
  }
  const vision::CameraModel model(resized(settings::load_camera(options.camera), options));
  const Times times = measure(model, options);
  const double bare_us = quantiles_of(times.bare).median_us;
  fmt::print(stderr,
             "{}x{}; budget of the table: 0.5 s\n{:16} {} {:>8}\n",
             options.width_px,
             options.height_px,
             "",
             table_head(),
             "/ bare");
  report("bare rays", times.bare, bare_us);
  report("table", times.table, bare_us);
  return process::kDone;
}

}  // namespace
}  // namespace teamsight::bench

int main(int argc, char** argv) {
  return teamsight::process::run_program("bench-rays",
                                         [&] { return teamsight::bench::run(argc, argv); });
}
