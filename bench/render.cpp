// bench/render.cpp: how long the simulator draws a frame, beside what copying the frame's light
// would take.
//
// The kinds of picture take turns with the copy, so that a disturbance of the machine meets all.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/quantiles.hpp"
#include "process/program.hpp"
#include "sim/setup.hpp"
#include "sim/show.hpp"

namespace teamsight::bench {
namespace {

using Clock = std::chrono::steady_clock;

struct Kind {
  std::string name;
  sim::Eye eye;
  std::vector<Duration> draws;
};

Duration since(Clock::time_point start) {
  return std::chrono::duration_cast<Duration>(Clock::now() - start);
}

Kind make_kind(const std::string& name, sim::Setup setup, int samples, int moments) {
  setup.match.picture.samples_per_axis = samples;
  setup.match.picture.moments = moments;
  return {fmt::format("{}, {}x{} samples, {} moments", name, samples, samples, moments),
          sim::make_eye(setup, 0, setup.camera.format),
          {}};
}

// The canvas of a frame's light and another to copy it to.
class LightCopy {
 public:
  explicit LightCopy(std::size_t pixels) : light_(pixels, sim::Light(0.5F)), copy_(pixels) {}

  void make() { copy_ = light_; }

 private:
  sim::Canvas light_;
  sim::Canvas copy_;
};

// Draws every kind once per frame of the match at its rate, and copies one frame's light.
void measure(const sim::Setup& setup,
             int frames,
             std::vector<Kind>& kinds,
             std::vector<Duration>& copies) {
  LightCopy copy(std::size_t{setup.camera.width_px} * setup.camera.height_px);
  sim::Match match(setup.parameters, setup.field);
  sim::Random random(1);
  sim::Scene scene;
  std::vector<std::uint8_t> picture;
  for (int frame = 0; frame < frames; ++frame) {
    match.advance_to(frame / setup.match.frame_rate_hz);
    sim::show(match.state(), 0, kinds.front().eye.bodies, scene);
    for (Kind& kind : kinds) {
      const auto start = Clock::now();
      kind.eye.renderer.draw(scene, random, picture);
      kind.draws.push_back(since(start));
    }
    const auto start = Clock::now();
    copy.make();
    copies.push_back(since(start));
  }
}

void report(const std::string& name, const Quantiles& q, double copy_us, double rate_hz) {
  fmt::print("{{\"bench\":\"render\",\"picture\":\"{}\",{},\"over_copy\":{:.1f}}}\n",
             name,
             json_members(q),
             q.median_us / copy_us);
  fmt::print(stderr,
             "{:36} {} {:>8.1f} {:>8.0f} %\n",
             name,
             table_columns(q),
             q.median_us / copy_us,
             q.median_us * rate_hz / 1e4);
}

int run(int argc, const char* const* argv) {
  std::string match;
  int frames = 60;
  bool only_live = false;
  CLI::App app("Measures how long a simulated camera's frame is drawn.");
  app.add_option("--match", match, "match file (config/matches)")->required();
  app.add_option("--frames", frames)->capture_default_str()->check(CLI::PositiveNumber);
  app.add_flag("--live", only_live, "only as for a live match: a careful picture takes 0.5 s");
  if (const std::optional<int> done = process::parse_command_line(app, argc, argv)) {
    return *done;
  }
  const sim::Setup setup = sim::load_setup(match, {}, {});
  std::vector<Kind> kinds;
  kinds.push_back(make_kind("live", setup, 1, 1));
  if (!only_live) {
    kinds.push_back(make_kind("score", setup, 3, 4));
  }
  std::vector<Duration> copies;
  measure(setup, frames, kinds, copies);

  const Quantiles copy = quantiles_of(copies);
  fmt::print(stderr,
             "{}x{}, {:.0f} Hz\n{:36} {} {:>8} {:>10}\n",
             setup.camera.width_px,
             setup.camera.height_px,
             setup.match.frame_rate_hz,
             "",
             table_head(),
             "/ copy",
             "of a core");
  report("copy of the light", copy, copy.median_us, setup.match.frame_rate_hz);
  for (const Kind& kind : kinds) {
    report(kind.name, quantiles_of(kind.draws), copy.median_us, setup.match.frame_rate_hz);
  }
  return process::kDone;
}

}  // namespace
}  // namespace teamsight::bench

int main(int argc, char** argv) {
  return teamsight::process::run_program("bench-render",
                                         [&] { return teamsight::bench::run(argc, argv); });
}
