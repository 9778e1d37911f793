// tools/labelled_images.hpp: hand-labelled images, and which camera and series each belongs to.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/detection_score.hpp"
#include "vision/calibration/obstacle_training.hpp"

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

/// What stands in one series' images.
struct SeriesSamples {
  std::string series;
  std::vector<vision::ObstacleSample> samples;
};

/// Looks at all images for whatever might be a robot. People, and robots whose label is not sure,
/// teach nothing.
///
/// @throws std::runtime_error if an image cannot be read
[[nodiscard]] std::vector<SeriesSamples> obstacle_samples(const std::filesystem::path& data,
                                                          const std::vector<LabelledImage>& images);

/// Of all series but the one with this name; all if it is empty.
///
/// @throws std::runtime_error if there are too few
[[nodiscard]] vision::ObstacleModel model_without(const std::string& series,
                                                  const std::vector<SeriesSamples>& all);

}  // namespace teamsight::tools
