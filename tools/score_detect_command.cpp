// tools/score_detect_command.cpp: detections in labelled images, counted by camera and by team.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/detection_score.hpp"
#include "tools/score_command.hpp"
#include "tools/sight_drawing.hpp"
#include "tools/unknown_field.hpp"
#include "tools/viewer.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;

struct ScoreDetectOptions {
  std::string data;
  std::string cameras;
  std::string draw;
  std::string only_camera;
};

/// Which camera took the images whose names begin like this.
struct CameraRule {
  std::string prefix;
  std::filesystem::path camera;
};

std::vector<CameraRule> read_rules(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path.string() + ": cannot be read");
  std::vector<CameraRule> rules;
  std::string text;
  while (std::getline(file, text)) {
    std::istringstream line(text);
    std::string prefix;
    std::string camera;
    if (!(line >> prefix) || prefix.starts_with('#')) continue;
    if (!(line >> camera)) {
      throw std::runtime_error(path.string() + ": found '" + text +
                               "', expected the beginning of an image's name and a camera file");
    }
    rules.push_back({prefix, path.parent_path() / camera});
  }
  return rules;
}

// The longest beginning that fits.
const CameraRule* rule_for(const std::vector<CameraRule>& rules, const std::string& image) {
  const CameraRule* best = nullptr;
  for (const CameraRule& rule : rules) {
    if (!image.starts_with(rule.prefix)) continue;
    if (best == nullptr || rule.prefix.size() > best->prefix.size()) best = &rule;
  }
  return best;
}

/// Both kinds of things in one set of images.
struct Score {
  Tally balls;
  Tally robots;
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
  std::cout << line.dump() << std::endl;
}

Score score_of(const ImageLabels& labels, const vision::FrameObservation& seen) {
  std::vector<Detection> balls;
  for (const vision::BallPixels& ball : seen.ball_pixels) {
    balls.push_back({ball.u_px, ball.v_px, ball.on_carpet});
  }
  std::vector<Detection> obstacles;
  for (const vision::ObstaclePixels& foot : seen.obstacle_pixels) {
    obstacles.push_back({foot.u_px, foot.v_px, foot.on_carpet});
  }
  return {score_balls(labels, balls), score_robots(labels, obstacles)};
}

int score_detect(const ScoreDetectOptions& options) {
  const std::filesystem::path data = options.data;
  const auto rules = read_rules(options.cameras);
  const FieldModel field = unknown_field();
  if (!options.draw.empty()) std::filesystem::create_directories(options.draw);
  std::map<std::string, Viewer> viewers;
  std::map<std::string, Score> by_camera;
  std::map<std::string, Score> by_team;
  Score all;
  for (const ImageLabels& labels : read_labels((data / "labels.json").string())) {
    const CameraRule* rule = rule_for(rules, labels.image);
    if (rule == nullptr) continue;
    const std::string camera =
        options.only_camera.empty() ? rule->camera.string() : options.only_camera;
    const auto [viewer, is_new] = viewers.try_emplace(camera, settings::load_camera(camera), field);
    const Viewed viewed = viewer->second.look(data / labels.image, {});
    const Score score = score_of(labels, *viewed.seen);
    for (Score* sum : {&all,
                       &by_camera[rule->camera.stem().string()],
                       &by_team[labels.image.substr(0, labels.image.find('/'))]}) {
      sum->balls += score.balls;
      sum->robots += score.robots;
    }
    if (!options.draw.empty()) {
      // Teams number their images alike: the folders' names tell them apart.
      std::string name = std::filesystem::path(labels.image).replace_extension(".png").string();
      std::replace(name.begin(), name.end(), '/', '_');
      write_marked_frame(std::filesystem::path(options.draw) / name,
                         {labels.image, viewed.frame, {}},
                         *viewed.seen);
    }
  }
  for (const auto& [name, score] : by_camera) print("camera", name, score);
  for (const auto& [name, score] : by_team) print("team", name, score);
  print("all", "images", all);
  return 0;
}

}  // namespace

void add_score_detect_command(CLI::App& score, int& exit_code) {
  auto options = std::make_shared<ScoreDetectOptions>();
  CLI::App* command =
      score.add_subcommand("detect", "balls and robots in hand-labelled images of real teams");
  command->add_option("--data", options->data, "folder with labels.json and the images")
      ->required();
  command
      ->add_option("--cameras",
                   options->cameras,
                   "text file: beginning of an image's name, camera file; the longest one counts")
      ->required();
  command->add_option("--camera", options->only_camera, "one camera file for all of them instead");
  command->add_option("--draw", options->draw, "folder for a picture of each image");
  command->callback([options, &exit_code] { exit_code = score_detect(*options); });
}

}  // namespace teamsight::tools
