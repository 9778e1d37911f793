// tools/score_detect_command.cpp: detections in labelled images, counted by series and by team.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/detection_score.hpp"
#include "tools/labelled_images.hpp"
#include "tools/score_command.hpp"
#include "tools/sight_drawing.hpp"
#include "tools/unknown_field.hpp"
#include "tools/viewer.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;

struct ScoreDetectOptions {
  LabelledFolder folder;
  std::string draw;
  std::string only_camera;
  bool series_out{false};
};

/// Both kinds of things in one set of images.
struct Score {
  Tally balls;
  Tally robots;
  Tally people;
};

ordered_json entry_of(const Tally& tally) {
  const Interval recall = wilson(tally.found, tally.labelled);
  const Interval precision = wilson(tally.found, tally.found + tally.wrong);
  std::vector<double> errors = tally.errors_px;
  std::ranges::sort(errors);
  ordered_json entry;
  entry["labelled"] = tally.labelled;
  entry["found"] = tally.found;
  entry["false_on_carpet"] = tally.wrong;
  entry["off_carpet"] = tally.outside;
  entry["recall"] = tally.recall();
  entry["recall_95"] = {recall.low, recall.high};
  entry["precision"] = tally.precision();
  entry["precision_95"] = {precision.low, precision.high};
  entry["median_error_px"] =
      errors.empty() ? ordered_json() : ordered_json(errors[errors.size() / 2]);
  return entry;
}

void print(const std::string& kind, const std::string& name, const Score& score) {
  ordered_json line;
  line[kind] = name;
  line["balls"] = entry_of(score.balls);
  line["robots"] = entry_of(score.robots);
  line["people"] = {{"labelled", score.people.labelled}, {"found", score.people.found}};
  std::cout << line.dump() << std::endl;
}

Score score_of(const ImageLabels& labels, const vision::FrameObservation& seen) {
  std::vector<Detection> balls;
  for (const vision::BallPixels& ball : seen.ball_pixels) {
    balls.push_back({ball.u_px, ball.v_px, ball.on_carpet});
  }
  std::vector<Detection> obstacles;
  std::vector<Detection> robots;
  for (const vision::ObstaclePixels& foot : seen.obstacle_pixels) {
    obstacles.push_back({foot.u_px, foot.v_px, foot.on_carpet});
    if (foot.kind == vision::ObstacleKind::kRobot) robots.push_back(obstacles.back());
  }
  return {
      score_balls(labels, balls), score_robots(labels, robots), score_people(labels, obstacles)};
}

/// Scores of sets of images, by their name.
using Scores = std::map<std::string, Score>;

void add(Scores& scores, const std::string& name, const Score& score) {
  scores[name].balls += score.balls;
  scores[name].robots += score.robots;
  scores[name].people += score.people;
}

void draw(const std::filesystem::path& folder, const std::string& image, const Viewed& viewed) {
  // Teams number their images alike: the folders' names tell them apart.
  std::string name = std::filesystem::path(image).replace_extension(".png").string();
  std::replace(name.begin(), name.end(), '/', '_');
  write_marked_frame(folder / name, {image, viewed.frame, {}}, *viewed.seen);
}

int score_detect(const ScoreDetectOptions& options) {
  const std::vector<LabelledImage> images = read_labelled_images(options.folder);
  ObstacleSamples obstacles;
  BallSamples balls;
  if (options.series_out) {
    obstacles = obstacle_samples(options.folder.data, images);
    balls = ball_samples(options.folder.data, images);
  }
  if (!options.draw.empty()) std::filesystem::create_directories(options.draw);
  std::map<std::string, Viewer> viewers;
  Scores by_series;
  Scores by_team;
  Scores all;
  for (const auto& [labels, rule] : images) {
    const std::string camera =
        options.only_camera.empty() ? rule.camera.string() : options.only_camera;
    vision::PerceptionParameters parameters;
    if (options.series_out) {
      parameters.obstacles = model_without(rule.series, obstacles, kLeastOfRobots);
      parameters.balls = model_without(rule.series, balls, kLeastOfBalls);
    }
    const auto viewer =
        viewers
            .try_emplace(
                rule.series + camera, settings::load_camera(camera), unknown_field(), parameters)
            .first;
    const Viewed viewed = viewer->second.look(options.folder.data / labels.image, {});
    const Score score = score_of(labels, *viewed.seen);
    add(by_series, rule.series, score);
    add(by_team, labels.image.substr(0, labels.image.find('/')), score);
    add(all, "images", score);
    if (!options.draw.empty()) draw(options.draw, labels.image, viewed);
  }
  for (const auto& [name, score] : by_series) print("series", name, score);
  for (const auto& [name, score] : by_team) print("team", name, score);
  print("all", "images", all["images"]);
  return 0;
}

}  // namespace

void add_score_detect_command(CLI::App& score, int& exit_code) {
  auto options = std::make_shared<ScoreDetectOptions>();
  CLI::App* command =
      score.add_subcommand("detect", "balls and robots in hand-labelled images of real teams");
  command->add_option("--data", options->folder.data, "folder with labels.json and the images")
      ->required();
  command
      ->add_option(
          "--cameras",
          options->folder.cameras,
          "text file: beginning of an image's name, camera file, series; the longest counts")
      ->required();
  command->add_option("--camera", options->only_camera, "one camera file for all of them instead");
  command->add_flag("--series-out",
                    options->series_out,
                    "tell balls and robots by models trained on the other series only");
  command->add_option("--draw", options->draw, "folder for a picture of each image");
  command->callback([options, &exit_code] { exit_code = score_detect(*options); });
}

}  // namespace teamsight::tools
