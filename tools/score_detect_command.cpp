// tools/score_detect_command.cpp: detections in labelled images, counted by series and by team.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/contact_sheet.hpp"
#include "tools/detection_report.hpp"
#include "tools/frame_drawing.hpp"
#include "tools/labelled_images.hpp"
#include "tools/other_light.hpp"
#include "tools/score_command.hpp"
#include "tools/unknown_field.hpp"
#include "tools/viewer.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;

struct ScoreDetectOptions {
  LabelledFolder folder;
  std::string draw;
  std::string sheet;
  std::string only_camera;
  bool series_out{false};
  bool lights{false};
  bool fixed_light{false};
};

void print(const std::string& kind, std::string_view name, const Score& score) {
  ordered_json line;
  line[kind] = name;
  line.update(report_of(score));
  std::cout << line.dump() << std::endl;
}

/// Scores of sets of images, by their name.
using Scores = std::map<std::string, Score>;

/// Pictures of what was found and what the labels say of it, where they are asked for.
class JudgedPictures {
 public:
  explicit JudgedPictures(const ScoreDetectOptions& options) : folder_(options.draw) {
    if (!folder_.empty()) std::filesystem::create_directories(folder_);
    if (!options.sheet.empty()) sheets_.emplace(options.sheet);
  }

  void add(const ImageLabels& labels, const Viewed& viewed) {
    if (folder_.empty() && !sheets_) return;
    const Picture judged = judged_frame({labels.image, viewed.frame, {}}, *viewed.seen, labels);
    if (sheets_) sheets_->add(judged, labels.image);
    if (folder_.empty()) return;
    // Teams number their images alike: the folders' names tell them apart.
    std::string name = std::filesystem::path(labels.image).replace_extension(".png").string();
    std::replace(name.begin(), name.end(), '/', '_');
    write_picture(folder_ / name, judged);
  }

  void finish() {
    if (sheets_) sheets_->finish();
  }

 private:
  std::filesystem::path folder_;
  std::optional<ContactSheets> sheets_;
};

/// Looks at the labelled images through their cameras' files.
class Eyes {
 public:
  Eyes(const ScoreDetectOptions& options, const std::vector<LabelledImage>& images)
      : options_(options) {
    if (!options.series_out) return;
    obstacles_ = obstacle_samples(options.folder.data, images);
    balls_ = ball_samples(options.folder.data, images);
  }

  /// @return valid until the next call
  Viewed look(const LabelledImage& image, const OtherLight& light) {
    const std::string camera =
        options_.only_camera.empty() ? image.rule.camera.string() : options_.only_camera;
    const std::string key = image.rule.series + camera;
    auto viewer = viewers_.find(key);
    if (viewer == viewers_.end()) {
      viewer = viewers_
                   .try_emplace(key,
                                settings::load_camera(camera),
                                unknown_field(),
                                parameters_for(image.rule.series),
                                !options_.fixed_light)
                   .first;
    }
    const std::filesystem::path path = options_.folder.data / image.labels.image;
    if (light == OtherLight{}) return viewer->second.look(path, {});
    return viewer->second.look(
        in_light(read_image(path, viewer->second.camera()), light), path.string(), {});
  }

 private:
  [[nodiscard]] vision::PerceptionParameters parameters_for(const std::string& series) const {
    vision::PerceptionParameters parameters;
    if (!options_.series_out) return parameters;
    parameters.obstacles = model_without(series, obstacles_, kLeastOfRobots);
    parameters.balls = model_without(series, balls_, kLeastOfBalls);
    return parameters;
  }

  const ScoreDetectOptions& options_;
  ObstacleSamples obstacles_;
  BallSamples balls_;
  std::map<std::string, Viewer> viewers_;
};

void score_as_taken(const ScoreDetectOptions& options,
                    const std::vector<LabelledImage>& images,
                    Eyes& eyes) {
  JudgedPictures pictures(options);
  Scores by_series;
  Scores by_team;
  Score all;
  for (const LabelledImage& image : images) {
    const ImageLabels& labels = image.labels;
    const Viewed viewed = eyes.look(image, {});
    const Score score = score_of(labels, *viewed.seen);
    by_series[image.rule.series] += score;
    by_team[labels.image.substr(0, labels.image.find('/'))] += score;
    all += score;
    pictures.add(labels, viewed);
  }
  pictures.finish();
  for (const auto& [name, score] : by_series) print("series", name, score);
  for (const auto& [name, score] : by_team) print("team", name, score);
  print("all", "images", all);
}

void score_in_lights(const std::vector<LabelledImage>& images, Eyes& eyes) {
  Score others;
  for (const OtherLight& light : other_lights()) {
    Score score;
    for (const LabelledImage& image : images) {
      score += score_of(image.labels, *eyes.look(image, light).seen);
    }
    print("light", light.name, score);
    others += score;
  }
  print("all", "other lights", others);
}

int score_detect(const ScoreDetectOptions& options) {
  const std::vector<LabelledImage> images = read_labelled_images(options.folder);
  Eyes eyes(options, images);
  if (options.lights) {
    score_in_lights(images, eyes);
  } else {
    score_as_taken(options, images, eyes);
  }
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
  command->add_flag("--lights",
                    options->lights,
                    "score the same pictures in other light instead: brighter, with other casts, "
                    "noisy, blurred");
  command->add_flag("--fixed-light",
                    options->fixed_light,
                    "do not follow the light, even where the camera file names one");
  command->add_option(
      "--draw", options->draw, "folder for a picture of each image, with what labels say of it");
  command->add_option(
      "--sheet", options->sheet, "folder for contact sheets of all images, marked likewise");
  command->callback([options, &exit_code] { exit_code = score_detect(*options); });
}

}  // namespace teamsight::tools
