// tools/score_calibrate_command.cpp: robots with bent mirrors, rendered, calibrated, measured.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "sim/render/defects.hpp"
#include "sim/render/renderer.hpp"
#include "tools/line_views.hpp"
#include "tools/score_command.hpp"
#include "vision/calibration/line_calibration.hpp"
#include "vision/perception.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;

struct ScoreOptions {
  std::string camera{"config/cameras/sim-isometric.textproto"};
  std::string field{"config/fields/msl-2024.textproto"};
  std::uint32_t robots{20};
  std::uint32_t images{40};
  std::uint32_t seed{1};
  int fineness{2};
  double reach_m{6.0};
  double wanted_m{0.010};
};

/// What one robot's calibration came to; m.
struct RobotScore {
  std::optional<double> before;
  std::optional<double> after;
  double predicted{0.0};
  bool refused{false};
  std::size_t views_used{0};
};

// RMS over the floor from 1 m to `reach` of what the model says against where the renderer shows
// each place. Nothing if they share no floor.
std::optional<double> ground_error(const sim::Renderer& truth,
                                   const vision::CameraModel& model,
                                   double reach) {
  constexpr int kDirections = 36;
  double sum = 0.0;
  int count = 0;
  const int rings = static_cast<int>(std::floor((reach - 1.0) / 0.5 + 1e-9));
  for (int ring = 0; ring <= rings; ++ring) {
    const double distance = 1.0 + 0.5 * ring;
    for (int i = 0; i < kDirections; ++i) {
      const double azimuth = 2.0 * std::numbers::pi * i / kDirections;
      const Point3<Robot> p_R{distance * std::cos(azimuth), distance * std::sin(azimuth), 0.0};
      const auto place = truth.find(p_R);
      const auto seen = place ? model.on_plane({place->u, place->v}, 0.0) : std::nullopt;
      if (!seen) continue;
      sum += (seen->vector() - p_R.on_floor().vector()).squaredNorm();
      ++count;
    }
  }
  return count > 0 ? std::optional(std::sqrt(sum / count)) : std::nullopt;
}

// Somewhere on the lined part of the field, facing anywhere.
Pose<Field, Robot> somewhere(const FieldModel& field, sim::Random& random) {
  return {field.centre.x + random.uniform(-0.48, 0.48) * field.length,
          field.centre.y + random.uniform(-0.48, 0.48) * field.width,
          random.uniform(-std::numbers::pi, std::numbers::pi)};
}

using Frame = std::vector<std::uint8_t>;

std::vector<Frame> drive_around(sim::Renderer& renderer,
                                const FieldModel& field,
                                std::uint32_t images,
                                sim::Random& random) {
  std::vector<Frame> frames(images);
  for (Frame& frame : frames) {
    sim::Scene scene;
    scene.X_FR = somewhere(field, random);
    renderer.draw(scene, random, frame);
  }
  return frames;
}

std::vector<std::vector<vision::Pixel>> find_lines(const std::vector<Frame>& frames,
                                                   const vision::CameraParameters& camera,
                                                   const FieldModel& field) {
  vision::Perception perception(camera, field);
  const vision::CameraModel model(camera);
  std::vector<std::vector<vision::Pixel>> views;
  for (const Frame& frame : frames) {
    const auto seen = perception.see({frame, camera.width_px, camera.height_px, camera.format}, {});
    views.push_back(paint_middles(*seen.value(), model));  // the renderer's frames are whole
  }
  return views;
}

RobotScore score_robot(const vision::CameraParameters& camera,
                       const FieldModel& field,
                       const ScoreOptions& options,
                       std::uint32_t seed) {
  sim::PictureParameters picture;
  picture.fineness = options.fineness;
  sim::Renderer renderer(sim::with_defects(camera, sim::draw_defects(seed)), field, picture);
  sim::Random random(seed);
  const auto frames = drive_around(renderer, field, options.images, random);
  vision::LineCalibrationRules rules;
  rules.bundle.max_distance = camera.scan.max_distance;
  rules.reach = options.reach_m;
  const auto found = vision::calibrate_lines(
      vision::LineMap(field),
      camera,
      [&](const vision::CameraParameters& eye) { return find_lines(frames, eye, field); },
      rules);
  RobotScore score;
  score.before = ground_error(renderer, vision::CameraModel(camera), options.reach_m);
  score.after = ground_error(renderer, vision::CameraModel(found.camera), options.reach_m);
  score.predicted = found.ground_sigma;
  score.refused = found.refusal.has_value();
  score.views_used =
      static_cast<std::size_t>(std::ranges::count(found.views, true, &vision::ViewResult::used));
  return score;
}

ordered_json json_of(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

double rms(const std::vector<RobotScore>& scores, std::optional<double> RobotScore::*which) {
  double sum = 0.0;
  for (const RobotScore& score : scores) sum += std::pow((score.*which).value_or(HUGE_VAL), 2);
  return std::sqrt(sum / static_cast<double>(scores.size()));
}

int score_calibrate(const ScoreOptions& options) {
  const vision::CameraParameters camera = settings::load_camera(options.camera);
  if (!std::holds_alternative<vision::ProfileMirror>(camera.mirror)) {
    throw std::runtime_error(options.camera + ": mirror: found radial_table, expected profile");
  }
  const FieldModel field = settings::load_field(options.field);
  std::vector<RobotScore> scores;
  double worst = 0.0;
  for (std::uint32_t robot = 0; robot < options.robots; ++robot) {
    scores.push_back(score_robot(camera, field, options, options.seed + robot));
    const RobotScore& score = scores.back();
    worst = std::max(worst, score.refused ? HUGE_VAL : score.after.value_or(HUGE_VAL));
    std::cout << ordered_json{{"robot_seed", options.seed + robot},
                              {"images", options.images},
                              {"views_used", score.views_used},
                              {"refused", score.refused},
                              {"before_m", json_of(score.before)},
                              {"after_m", json_of(score.after)},
                              {"predicted_m", score.predicted}}
                     .dump()
              << std::endl;
  }
  std::cout << ordered_json{{"robots", options.robots},
                            {"images", options.images},
                            {"reach_m", options.reach_m},
                            {"before_rms_m", rms(scores, &RobotScore::before)},
                            {"after_rms_m", rms(scores, &RobotScore::after)},
                            {"after_worst_m", worst},
                            {"wanted_m", options.wanted_m}}
                   .dump()
            << std::endl;
  return worst <= options.wanted_m ? 0 : 1;
}

}  // namespace

void add_score_calibrate_command(CLI::App& score, int& exit_code) {
  auto options = std::make_shared<ScoreOptions>();
  CLI::App* command = score.add_subcommand(
      "calibrate", "Robots with bent mirrors, rendered and calibrated from lines");
  command->add_option("--camera", options->camera, "camera file with a profile mirror")
      ->capture_default_str();
  command->add_option("--field", options->field, "field file")->capture_default_str();
  command->add_option("--robots", options->robots)
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--images", options->images, "of each robot")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "of the first robot")->capture_default_str();
  command->add_option("--fineness", options->fineness, "rendered samples per pixel and axis")
      ->check(CLI::Range(1, 8))
      ->capture_default_str();
  command->add_option("--reach-m", options->reach_m)
      ->check(CLI::Range(1.0, 30.0))
      ->capture_default_str();
  command->add_option("--wanted-m", options->wanted_m, "more than this for any robot: exit 1")
      ->capture_default_str();
  command->callback([options, &exit_code] { exit_code = score_calibrate(*options); });
}

}  // namespace teamsight::tools
