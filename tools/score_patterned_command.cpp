// tools/score_patterned_command.cpp: see tools/score_patterned_command.hpp.
#include "tools/score_patterned_command.hpp"

#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/labelled_images.hpp"
#include "tools/patterned_scenes.hpp"
#include "tools/unknown_field.hpp"
#include "tools/viewer.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;
using Samples = std::vector<vision::TraitSample<vision::kPatternTraits>>;

constexpr std::size_t kBands = 6;          // of a metre each
constexpr double kLeastOfPatterned = 0.5;  // an invented ball harms as much as a missed one

struct PatternedOptions {
  std::string camera;
  std::string field;
  std::size_t frames{600};
  std::uint32_t seed{1};
  LabelledFolder pictures;  ///< in which no patterned ball is; empty: none
};

/// Balls of some distances.
struct Band {
  std::size_t shown{0};
  std::size_t found{0};
};

/// The detections of one frame that are patterned balls.
std::vector<Detection> patterned_in(const vision::FrameObservation& seen) {
  std::vector<Detection> balls;
  for (std::size_t i = 0; i < seen.balls.size(); ++i) {
    if (seen.balls[i].colour != BallColour::kPatterned) continue;
    const vision::BallPixels& pixels = seen.ball_pixels[i];
    balls.push_back({pixels.u_px, pixels.v_px, pixels.on_carpet});
  }
  return balls;
}

ordered_json share_of(std::size_t part, std::size_t whole) {
  if (whole == 0) return {};
  return static_cast<double>(part) / static_cast<double>(whole);
}

// Of one ball; all its frames.
void score(const PatternedBall& ball, const PatternedOptions& options) {
  const vision::CameraParameters camera = settings::load_camera(options.camera);
  const FieldModel field = settings::load_field(options.field);
  PatternedViews views(camera, field, ball, {});
  sim::Random random(options.seed);
  std::array<Band, kBands> bands;
  std::size_t right = 0;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < options.frames; ++i) {
    const PatternedViews::View view = views.look(random);
    const std::vector<Detection> balls = patterned_in(*view.seen);
    for (const Verdict verdict : judge_balls(view.labels, balls)) {
      if (verdict == Verdict::kRight) ++right;
      if (verdict == Verdict::kWrong) ++wrong;
    }
    if (!view.distance || view.labels.balls.empty() || !view.labels.balls[0].counts) continue;
    Band& band = bands.at(static_cast<std::size_t>(*view.distance));
    ++band.shown;
    if (balls_found(view.labels, balls)[0]) ++band.found;
  }
  for (std::size_t i = 0; i < kBands; ++i) {
    ordered_json line;
    line["ball"] = ball.name;
    line["from_m"] = i;
    line["to_m"] = i + 1;
    line["shown"] = bands[i].shown;
    line["found"] = bands[i].found;
    line["recall"] = share_of(bands[i].found, bands[i].shown);
    std::cout << line.dump() << std::endl;
  }
  ordered_json all;
  all["ball"] = ball.name;
  all["frames"] = options.frames;
  all["false"] = wrong;
  all["precision"] = share_of(right, right + wrong);
  std::cout << all.dump() << std::endl;
}

// Whatever may be a patterned ball in one frame, and whether it is.
void add_samples(const PatternedViews::View& view, Samples& samples) {
  const vision::FrameObservation& seen = *view.seen;
  std::vector<Detection> balls;
  std::vector<vision::PatternTraits> traits;
  for (std::size_t i = 0; i < seen.balls.size(); ++i) {
    if (seen.balls[i].colour != BallColour::kPatterned) continue;
    const vision::BallPixels& pixels = seen.ball_pixels[i];
    balls.push_back({pixels.u_px, pixels.v_px, pixels.on_carpet});
    traits.push_back(pixels.pattern);
  }
  const std::vector<Verdict> verdicts = judge_balls(view.labels, balls);
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i] == Verdict::kExcused) continue;
    samples.push_back({traits[i], verdicts[i] == Verdict::kRight});
  }
}

// What may pass for a white and black ball in pictures that show none.
void add_pictures(const LabelledFolder& folder,
                  const vision::PerceptionParameters& parameters,
                  Samples& samples) {
  std::map<std::string, Viewer> viewers;
  for (const LabelledImage& image : read_labelled_images(folder)) {
    const std::string path = image.rule.camera.string();
    auto viewer = viewers.find(path);
    if (viewer == viewers.end()) {
      vision::CameraParameters camera = settings::load_camera(path);
      camera.colours.pattern = {vision::ColourClass::kWhite, vision::ColourClass::kBlack};
      viewer = viewers.try_emplace(path, camera, unknown_field(), parameters).first;
    }
    const Viewed viewed = viewer->second.look(folder.data / image.labels.image, {});
    for (std::size_t i = 0; i < viewed.seen->balls.size(); ++i) {
      if (viewed.seen->balls[i].colour != BallColour::kPatterned) continue;
      samples.push_back({viewed.seen->ball_pixels[i].pattern, false});
    }
  }
}

void calibrate(const PatternedOptions& options) {
  const vision::CameraParameters camera = settings::load_camera(options.camera);
  const FieldModel field = settings::load_field(options.field);
  vision::PerceptionParameters parameters;
  parameters.patterned.least = 0.0;
  Samples samples;
  for (const PatternedBall& ball : patterned_balls()) {
    PatternedViews views(camera, field, ball, parameters);
    sim::Random random(options.seed);
    for (std::size_t i = 0; i < options.frames; ++i) add_samples(views.look(random), samples);
  }
  if (!options.pictures.data.empty()) add_pictures(options.pictures, parameters, samples);
  const auto model = vision::train<vision::kPatternTraits>(samples, kLeastOfPatterned);
  if (!model) throw std::runtime_error("found no ball, or nothing else, to train on");
  ordered_json line;
  for (std::size_t i = 0; i < vision::kPatternTraits; ++i) {
    line["weights"][std::string(vision::kPatternTraitNames[i])] = model->weights[i];
  }
  line["bias"] = model->bias;
  line["least"] = model->least;
  line["samples"] = samples.size();
  std::cout << line.dump() << std::endl;
}

std::shared_ptr<PatternedOptions> add_options(CLI::App& command) {
  auto options = std::make_shared<PatternedOptions>();
  command.add_option("--camera", options->camera, "camera file; the patterns are added")
      ->required();
  command.add_option("--field", options->field, "field file")->required();
  command.add_option("--frames", options->frames, "of each ball")->check(CLI::PositiveNumber);
  command.add_option("--seed", options->seed, "of the scenes");
  return options;
}

}  // namespace

void add_score_patterned_command(CLI::App& score_app, int& exit_code) {
  CLI::App* command = score_app.add_subcommand(
      "patterned", "patterned balls in rendered frames, by distance, and what is invented");
  const auto options = add_options(*command);
  command->callback([options, &exit_code] {
    for (const PatternedBall& ball : patterned_balls()) score(ball, *options);
    exit_code = 0;
  });
}

void add_calibrate_patterned(CLI::App& calibrate_app, int& exit_code) {
  CLI::App* command = calibrate_app.add_subcommand(
      "patterned", "Weights that tell patterned balls from other things, from rendered frames");
  const auto options = add_options(*command);
  auto* data = command->add_option(
      "--data", options->pictures.data, "folder with labels.json and images without such a ball");
  auto* cameras = command->add_option("--cameras",
                                      options->pictures.cameras,
                                      "text file: beginning of an image's name, camera file");
  data->needs(cameras);
  cameras->needs(data);
  command->callback([options, &exit_code] {
    calibrate(*options);
    exit_code = 0;
  });
}

}  // namespace teamsight::tools
