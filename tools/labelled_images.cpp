// tools/labelled_images.cpp: the list of cameras, and samples for training.
#include "tools/labelled_images.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <limits>
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

// Reports whatever stands anywhere, or has the ball's colour.
vision::PerceptionParameters everything() {
  vision::PerceptionParameters parameters;
  parameters.obstacles = {};
  parameters.obstacles.least = 0.0;
  parameters.balls = {};
  parameters.balls.least = 0.0;
  parameters.most_balls = std::numeric_limits<std::size_t>::max();
  return parameters;
}

// Where a frame shows what has these pixels.
template <class Pixels>
std::vector<Detection> places_of(const std::vector<Pixels>& all) {
  std::vector<Detection> places(all.size());
  std::ranges::transform(all, places.begin(), [](const Pixels& one) {
    return Detection{one.u_px, one.v_px, true};
  });
  return places;
}

/// @param pixels_of  those of an observation that may be what is wanted
/// @param judge      gives each a verdict, from an image's labels and their places
template <std::size_t kSize, class PixelsOf, class Judge>
std::vector<SeriesSamples<kSize>> samples_of(const std::filesystem::path& data,
                                             const std::vector<LabelledImage>& images,
                                             PixelsOf pixels_of,
                                             Judge judge) {
  std::map<std::string, Viewer> viewers;
  std::map<std::string, std::vector<vision::TraitSample<kSize>>> by_series;
  for (const LabelledImage& image : images) {
    const std::string camera = image.rule.camera.string();
    const auto viewer =
        viewers.try_emplace(camera, settings::load_camera(camera), unknown_field(), everything())
            .first;
    const Viewed viewed = viewer->second.look(data / image.labels.image, {});
    const auto& pixels = pixels_of(*viewed.seen);
    const std::vector<Verdict> verdicts = judge(image.labels, places_of(pixels));
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      if (verdicts[i] == Verdict::kExcused) continue;
      by_series[image.rule.series].push_back({pixels[i].traits, verdicts[i] == Verdict::kRight});
    }
  }
  std::vector<SeriesSamples<kSize>> all;
  all.reserve(by_series.size());
  for (auto& [series, samples] : by_series) all.push_back({series, std::move(samples)});
  return all;
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

ObstacleSamples obstacle_samples(const std::filesystem::path& data,
                                 const std::vector<LabelledImage>& images) {
  return samples_of<vision::kTraits>(
      data, images, std::mem_fn(&vision::FrameObservation::obstacle_pixels), judge_robots);
}

BallSamples ball_samples(const std::filesystem::path& data,
                         const std::vector<LabelledImage>& images) {
  return samples_of<vision::kBallTraits>(
      data, images, std::mem_fn(&vision::FrameObservation::ball_pixels), judge_balls);
}

}  // namespace teamsight::tools
