// tools/labelled_images.cpp: the list of cameras, and samples for training.
#include "tools/labelled_images.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "settings/load.hpp"
#include "tools/unknown_field.hpp"
#include "tools/viewer.hpp"

namespace teamsight::tools {

namespace {

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
    CameraRule rule{prefix, path.parent_path() / camera, {}};
    if (!(line >> rule.series)) rule.series = rule.camera.stem().string();
    rules.push_back(rule);
  }
  return rules;
}

const CameraRule* rule_for(const std::vector<CameraRule>& rules, const std::string& image) {
  const CameraRule* best = nullptr;
  for (const CameraRule& rule : rules) {
    if (!image.starts_with(rule.prefix)) continue;
    if (best == nullptr || rule.prefix.size() > best->prefix.size()) best = &rule;
  }
  return best;
}

// Reports whatever stands anywhere.
vision::PerceptionParameters everything() {
  vision::PerceptionParameters parameters;
  parameters.obstacles = {};
  parameters.obstacles.least = 0.0;
  return parameters;
}

}  // namespace

std::vector<LabelledImage> read_labelled_images(const LabelledFolder& folder) {
  const auto rules = read_rules(folder.cameras);
  std::vector<LabelledImage> images;
  for (const ImageLabels& labels : read_labels((folder.data / "labels.json").string())) {
    const CameraRule* rule = rule_for(rules, labels.image);
    if (rule != nullptr) images.push_back({labels, *rule});
  }
  return images;
}

std::vector<SeriesSamples> obstacle_samples(const std::filesystem::path& data,
                                            const std::vector<LabelledImage>& images) {
  std::map<std::string, Viewer> viewers;
  std::map<std::string, std::vector<vision::ObstacleSample>> by_series;
  for (const LabelledImage& image : images) {
    const std::string camera = image.rule.camera.string();
    const auto viewer =
        viewers.try_emplace(camera, settings::load_camera(camera), unknown_field(), everything())
            .first;
    const vision::FrameObservation& seen = *viewer->second.look(data / image.labels.image, {}).seen;
    std::vector<Detection> feet(seen.obstacle_pixels.size());
    std::ranges::transform(seen.obstacle_pixels, feet.begin(), [](const auto& foot) {
      return Detection{foot.u_px, foot.v_px, true};
    });
    const std::vector<Verdict> verdicts = judge_robots(image.labels, feet);
    for (std::size_t i = 0; i < feet.size(); ++i) {
      if (verdicts[i] == Verdict::kExcused) continue;
      by_series[image.rule.series].push_back(
          {seen.obstacle_pixels[i].traits, verdicts[i] == Verdict::kRight});
    }
  }
  std::vector<SeriesSamples> all;
  all.reserve(by_series.size());
  for (auto& [series, samples] : by_series) all.push_back({series, std::move(samples)});
  return all;
}

vision::ObstacleModel model_without(const std::string& series,
                                    const std::vector<SeriesSamples>& all) {
  std::vector<vision::ObstacleSample> samples;
  for (const SeriesSamples& one : all) {
    if (one.series == series) continue;
    samples.insert(samples.end(), one.samples.begin(), one.samples.end());
  }
  const auto model = vision::train_obstacle_model(samples);
  if (!model) throw std::runtime_error("found no robots, or nothing else, to train on");
  return *model;
}

}  // namespace teamsight::tools
