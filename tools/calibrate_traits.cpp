// tools/calibrate_traits.cpp: trains the models of balls and robots on labelled images.
#include "tools/calibrate_traits.hpp"

#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "tools/labelled_images.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;

/// @param least  probability from which the thing is reported
template <std::size_t kSize>
void print(const std::array<std::string_view, kSize>& names,
           const std::vector<SeriesSamples<kSize>>& samples,
           double least) {
  const vision::TraitModel<kSize> model = model_without({}, samples, least);
  ordered_json line;
  for (std::size_t i = 0; i < kSize; ++i) line["weights"][std::string(names[i])] = model.weights[i];
  line["bias"] = model.bias;
  line["least"] = model.least;
  for (const SeriesSamples<kSize>& one : samples) line["samples"][one.series] = one.samples.size();
  std::cout << line.dump() << std::endl;
}

int calibrate_robots(const LabelledFolder& folder) {
  print(vision::kTraitNames,
        obstacle_samples(folder.data, read_labelled_images(folder)),
        kLeastOfRobots);
  return 0;
}

int calibrate_balls(const LabelledFolder& folder) {
  print(vision::kBallTraitNames,
        ball_samples(folder.data, read_labelled_images(folder)),
        kLeastOfBalls);
  return 0;
}

void add(CLI::App& calibrate,
         const std::string& name,
         const std::string& description,
         int (*run)(const LabelledFolder&),
         int& exit_code) {
  auto folder = std::make_shared<LabelledFolder>();
  CLI::App* command = calibrate.add_subcommand(name, description);
  command->add_option("--data", folder->data, "folder with labels.json and the images")->required();
  command
      ->add_option("--cameras",
                   folder->cameras,
                   "text file: beginning of an image's name, camera file, series")
      ->required();
  command->callback([folder, run, &exit_code] { exit_code = run(*folder); });
}

}  // namespace

void add_calibrate_traits(CLI::App& calibrate, int& exit_code) {
  add(calibrate,
      "balls",
      "Weights that tell balls from what has their colour, from labelled images",
      calibrate_balls,
      exit_code);
  add(calibrate,
      "robots",
      "Weights that tell robots from their surroundings, from labelled images",
      calibrate_robots,
      exit_code);
}

}  // namespace teamsight::tools
