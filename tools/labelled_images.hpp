// tools/labelled_images.hpp: hand-labelled images, and which camera and series each belongs to.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/detection_score.hpp"
#include "vision/ball_traits.hpp"
#include "vision/calibration/trait_training.hpp"
#include "vision/obstacle_traits.hpp"

namespace teamsight::tools {

/// Which camera took the images whose names begin like this.
struct CameraRule {
  std::string prefix;
  std::filesystem::path camera;
  std::string series;  ///< taken at one place in one light; else the camera file's name
};

/// An image and whose it is.
struct LabelledImage {
  ImageLabels labels;
  CameraRule rule;
};

/// Where labelled images are.
struct LabelledFolder {
  std::filesystem::path data;     ///< with labels.json and the images
  std::filesystem::path cameras;  ///< lines of: beginning of a name, camera file, series if wanted
};

/// Those that a rule fits; of several, the longest beginning counts.
///
/// @throws std::runtime_error naming the file and what is wrong
[[nodiscard]] std::vector<LabelledImage> read_labelled_images(const LabelledFolder& folder);

/// What one series' images show.
template <std::size_t kSize>
struct SeriesSamples {
  std::string series;
  std::vector<vision::TraitSample<kSize>> samples;
};

using ObstacleSamples = std::vector<SeriesSamples<vision::kTraits>>;
using BallSamples = std::vector<SeriesSamples<vision::kBallTraits>>;

/// Looks at all images for whatever might be a robot. People, and robots whose label is not sure,
/// teach nothing.
///
/// @throws std::runtime_error if an image cannot be read
[[nodiscard]] ObstacleSamples obstacle_samples(const std::filesystem::path& data,
                                               const std::vector<LabelledImage>& images);

/// Looks at all images for whatever has the ball's colour. Balls off the field, and those whose
/// label is not sure, teach nothing.
///
/// @throws std::runtime_error if an image cannot be read
[[nodiscard]] BallSamples ball_samples(const std::filesystem::path& data,
                                       const std::vector<LabelledImage>& images);

/// From how probable on something is reported: half would favour the commoner kind, which is that
/// of the other things.
inline constexpr double kLeastOfRobots = 0.4;
inline constexpr double kLeastOfBalls = 0.4;

/// Trained on all series but the one with this name; on all if it is empty.
///
/// @throws std::runtime_error if there are too few
template <std::size_t kSize>
[[nodiscard]] vision::TraitModel<kSize> model_without(const std::string& series,
                                                      const std::vector<SeriesSamples<kSize>>& all,
                                                      double least) {
  std::vector<vision::TraitSample<kSize>> samples;
  for (const SeriesSamples<kSize>& one : all) {
    if (one.series == series) continue;
    samples.insert(samples.end(), one.samples.begin(), one.samples.end());
  }
  const auto model = vision::train<kSize>(samples, least);
  if (!model)
    throw std::runtime_error("found nothing that is wanted, or nothing else, to train on");
  return *model;
}

}  // namespace teamsight::tools
