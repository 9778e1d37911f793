// tools/score_shirts_command.cpp: team mates told by their shirts in rendered frames.
#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/score_command.hpp"
#include "tools/score_rounding.hpp"
#include "tools/shirt_score.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;

struct ScoreShirtsOptions {
  std::string camera{"config/cameras/sim-640.textproto"};
  std::string field{"config/fields/msl-2024.textproto"};
  ShirtField where;
  bool fit{false};
};

struct RangeBand {
  double from{0.0};  ///< m
  double to{0.0};    ///< m
};

constexpr std::array<RangeBand, 3> kBands{{{0.0, 1.5}, {1.5, 3.0}, {3.0, 8.0}}};

ordered_json json_of(std::span<const ShirtSample> samples, const vision::VoteModel& model) {
  const Calibration calibration = calibration_of(samples, model);
  ordered_json line;
  line["robots"] = calibration.count;
  line["told"] = calibration.told;
  line["right"] = rounded(calibration.right);
  line["claimed"] = rounded(calibration.claimed);
  line["log_loss"] = rounded(calibration.log_loss);
  line["brier"] = rounded(calibration.brier);
  for (const ReliabilityBin& bin : reliability_of(samples, model)) {
    line["reliability"].push_back(
        {{"robots", bin.count}, {"claimed", rounded(bin.claimed)}, {"own", rounded(bin.own)}});
  }
  return line;
}

void print(const std::string& kind, const std::string& name, const ordered_json& figures) {
  ordered_json line;
  line[kind] = name;
  line.update(figures);
  std::cout << line.dump() << std::endl;
}

int score_shirts(const ScoreShirtsOptions& options) {
  ShirtField where = options.where;
  where.camera = settings::load_camera(options.camera);
  where.field = settings::load_field(options.field);
  std::vector<ShirtSample> all;
  for (const ShirtPair& pair : shirt_pairs()) {
    const std::vector<ShirtSample> samples = look_at_shirts(where, pair);
    print("shirts", pair.name, json_of(samples, {}));
    all.insert(all.end(), samples.begin(), samples.end());
  }
  for (const RangeBand& band : kBands) {
    std::vector<ShirtSample> near;
    for (const ShirtSample& sample : all) {
      if (sample.range >= band.from && sample.range < band.to) near.push_back(sample);
    }
    print("range_m", fmt::format("{:.1f} to {:.1f}", band.from, band.to), json_of(near, {}));
  }
  print("all", "robots", json_of(all, {}));
  if (!options.fit) return 0;
  const vision::VoteModel fitted = fitted_votes(all);
  ordered_json figures = json_of(all, fitted);
  figures["wrong"] = rounded(fitted.wrong);
  figures["correlation"] = rounded(fitted.correlation);
  print("fitted", "all", figures);
  return 0;
}

}  // namespace

void add_score_shirts_command(CLI::App& score, int& exit_code) {
  auto options = std::make_shared<ScoreShirtsOptions>();
  CLI::App* command = score.add_subcommand(
      "shirts", "team mates told by their shirts in rendered frames, and whether as often as said");
  command->add_option("--camera", options->camera, "camera file");
  command->add_option("--field", options->field, "field file");
  command->add_option("--lights", options->where.lights, "of each pair of shirts")
      ->check(CLI::PositiveNumber);
  command->add_option("--frames", options->where.frames, "in each light")
      ->check(CLI::PositiveNumber);
  command->add_option("--light-sigma", options->where.light_sigma, "of a colour's gain, logarithm")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--paint-sigma", options->where.paint_sigma, "of a shirt's paint, levels")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--seed", options->where.seed, "of lights, paints and scenes");
  command->add_flag("--fit", options->fit, "also the model of votes that would serve these best");
  command->callback([options, &exit_code] { exit_code = score_shirts(*options); });
}

}  // namespace teamsight::tools
