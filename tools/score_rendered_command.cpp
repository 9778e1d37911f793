// tools/score_rendered_command.cpp: detections in rendered frames, by format and by light.
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/detection_report.hpp"
#include "tools/rendered_field.hpp"
#include "tools/score_command.hpp"
#include "vision/light_adaptation.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;
using vision::LightGains;
using vision::PixelFormat;

constexpr double kLookPeriod = 2.0;  // s that one look at the light speaks for: each frame counts

struct ScoreRenderedOptions {
  std::string camera;
  std::string field;
  std::size_t frames{50};
  std::uint32_t seed{1};
};

struct Format {
  const char* name;
  PixelFormat format;
};

constexpr std::array<Format, 5> kFormats{{{"YUYV", PixelFormat::kYuyv},
                                          {"UYVY", PixelFormat::kUyvy},
                                          {"NV12", PixelFormat::kNv12},
                                          {"BAYER_RGGB", PixelFormat::kBayerRggb},
                                          {"BGR", PixelFormat::kBgr}}};

struct Light {
  const char* name{""};
  LightGains gains;  ///< of what the camera shows
};

constexpr std::array<Light, 6> kLights{{{"as calibrated", {1.0, 1.0, 1.0}},
                                        {"dim", {0.5, 0.5, 0.5}},
                                        {"sun", {1.6, 1.6, 1.6}},
                                        {"evening", {1.1, 0.75, 0.45}},
                                        {"cold dusk", {0.42, 0.55, 0.8}},
                                        {"pink lamps", {0.9, 0.55, 0.9}}}};

// Light goes through the sensor's curve, a square root.
sim::PictureParameters picture_in(const LightGains& gains) {
  sim::PictureParameters picture;
  picture.fineness = 2;
  picture.sensor.red_gain = gains.red * gains.red;
  picture.sensor.green_gain = gains.green * gains.green;
  picture.sensor.blue_gain = gains.blue * gains.blue;
  return picture;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

ordered_json median_or_null(const std::vector<double>& values) {
  return values.empty() ? ordered_json() : ordered_json(median_of(values));
}

/// The same scenes in one format and light.
class Series {
 public:
  Series(const vision::CameraParameters& camera, const FieldModel& field, const LightGains& light)
      : camera_(camera),
        field_(field),
        perception_(camera, field),
        renderer_(camera, field, picture_in(light)) {}

  /// @param reference  what the field looks like as calibrated; nothing: the light is not followed
  ordered_json score(const ScoreRenderedOptions& options,
                     const std::optional<vision::FieldColours>& reference) {
    vision::LightAdaptation light(reference);
    sim::Random scenes(options.seed);
    sim::Random noise(options.seed);
    Score score;
    FloorErrors errors;
    perception_.adapt({});
    for (std::size_t i = 0; i < options.frames; ++i) {
      const sim::Scene scene = random_scene(field_, scenes);
      renderer_.draw(scene, noise, bytes_);
      light.take(reference ? perception_.field_colours(frame()) : std::nullopt, kLookPeriod);
      perception_.adapt(light.state().gains);
      vision::MotionPrior prior;
      prior.X_FR = scene.X_FR;
      const vision::FrameObservation& seen = **perception_.see(frame(), prior);
      const ImageLabels labels = labels_of(scene, renderer_, {});
      score += score_of(labels, seen);
      add_floor_errors(scene, labels, seen, errors);
    }
    ordered_json report = report_of(score);
    report["balls"]["median_error_m"] = median_or_null(errors.balls);
    report["robots"]["median_error_m"] = median_or_null(errors.robots);
    return report;
  }

  /// What the field looks like in the first scene.
  std::optional<vision::FieldColours> colours(std::uint32_t seed) {
    sim::Random scenes(seed);
    renderer_.draw(random_scene(field_, scenes), scenes, bytes_);
    return perception_.field_colours(frame());
  }

 private:
  [[nodiscard]] vision::ImageView frame() const {
    return {bytes_, camera_.width_px, camera_.height_px, camera_.format};
  }

  vision::CameraParameters camera_;
  const FieldModel& field_;
  vision::Perception perception_;
  sim::Renderer renderer_;
  std::vector<std::uint8_t> bytes_;
};

void print(const Format& format, const Light& light, bool follows, const ordered_json& report) {
  ordered_json line;
  line["format"] = format.name;
  line["light"] = light.name;
  line["follows_light"] = follows;
  line.update(report);
  std::cout << line.dump() << std::endl;
}

int score_rendered(const ScoreRenderedOptions& options) {
  vision::CameraParameters camera = settings::load_camera(options.camera);
  const FieldModel field = settings::load_field(options.field);
  for (const Format& format : kFormats) {
    camera.format = format.format;
    const auto reference = Series(camera, field, {}).colours(options.seed);
    for (const Light& light : kLights) {
      Series series(camera, field, light.gains);
      print(format, light, false, series.score(options, std::nullopt));
      print(format, light, true, series.score(options, reference));
    }
  }
  return 0;
}

}  // namespace

void add_score_rendered_command(CLI::App& score, int& exit_code) {
  auto options = std::make_shared<ScoreRenderedOptions>();
  CLI::App* command = score.add_subcommand(
      "rendered", "balls and robots in rendered frames of every format, in several lights");
  command->add_option("--camera", options->camera, "camera file; its format is not asked")
      ->required();
  command->add_option("--field", options->field, "field file")->required();
  command->add_option("--frames", options->frames, "of each format and light")
      ->check(CLI::PositiveNumber);
  command->add_option("--seed", options->seed, "of the scenes");
  command->callback([options, &exit_code] { exit_code = score_rendered(*options); });
}

}  // namespace teamsight::tools
