// tools/calibrate_robots.cpp: trains the obstacle model on labelled images.
#include "tools/calibrate_robots.hpp"

#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "tools/labelled_images.hpp"

namespace teamsight::tools {

namespace {

int calibrate_robots(const LabelledFolder& folder) {
  const auto samples = obstacle_samples(folder.data, read_labelled_images(folder));
  const vision::ObstacleModel model = model_without({}, samples);
  nlohmann::ordered_json line;
  for (std::size_t i = 0; i < vision::kTraits; ++i) {
    line["weights"][std::string(vision::kTraitNames[i])] = model.weights[i];
  }
  line["bias"] = model.bias;
  line["least"] = model.least;
  for (const SeriesSamples& one : samples) line["samples"][one.series] = one.samples.size();
  std::cout << line.dump() << std::endl;
  return 0;
}

}  // namespace

void add_calibrate_robots(CLI::App& calibrate, int& exit_code) {
  auto folder = std::make_shared<LabelledFolder>();
  CLI::App* robots = calibrate.add_subcommand(
      "robots", "Weights that tell robots from their surroundings, from labelled images");
  robots->add_option("--data", folder->data, "folder with labels.json and the images")->required();
  robots
      ->add_option("--cameras",
                   folder->cameras,
                   "text file: beginning of an image's name, camera file, series")
      ->required();
  robots->callback([folder, &exit_code] { exit_code = calibrate_robots(*folder); });
}

}  // namespace teamsight::tools
