// tools/mirror_command.cpp: options, files and lines of `teamsight mirror`.
#include "tools/mirror_command.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/mirror_file.hpp"
#include "tools/mirror_drawings.hpp"
#include "tools/mirror_report.hpp"
#include "tools/output_folder.hpp"
#include "tools/svg_plot.hpp"
#include "vision/mirror/design.hpp"

namespace teamsight::tools {
namespace {

namespace fs = std::filesystem;

constexpr int kDone = 0;
constexpr int kAnswerIsNo = 1;

struct Options {
  std::vector<std::string> configs;
  std::string out;
  std::vector<double> pixel_radii;
  std::vector<double> distances_m{1.0, 2.0, 4.0, 6.0, 8.0, 11.2};
};

/// A design file and the mirror it makes.
struct Designed {
  fs::path file;
  std::optional<double> pixel_pitch;
  mirror::Mirror mirror;
};

/// @return nothing if a design does not close; it has then said which one and why
std::optional<std::vector<Designed>> design_all(const std::vector<std::string>& configs) {
  std::vector<Designed> result;
  for (const std::string& config : configs) {
    const settings::MirrorSettings settings = settings::load_mirror(config);
    auto mirror = mirror::design(settings.parameters);
    if (!mirror) {
      std::cerr << "teamsight mirror: " << config << ": " << mirror.error().text << '\n';
      return std::nullopt;
    }
    result.push_back({config, settings.pixel_pitch, std::move(*mirror)});
  }
  return result;
}

/// Where a mirror's own files go: with several mirrors, a folder named after the design file.
fs::path folder_of(const Designed& design, std::size_t count) {
  return count > 1 ? design.file.stem() : fs::path();
}

void check_names(const std::vector<std::string>& configs) {
  std::vector<fs::path> names(configs.begin(), configs.end());
  std::transform(
      names.begin(), names.end(), names.begin(), [](const fs::path& path) { return path.stem(); });
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) {
    throw std::runtime_error("--config: found two files named " + twice->string() +
                             ", expected different names: each gets a folder of its own");
  }
}

std::vector<mirror::Mirror> mirrors_of(const std::vector<Designed>& designs) {
  std::vector<mirror::Mirror> mirrors;
  mirrors.reserve(designs.size());
  for (const Designed& design : designs) {
    mirrors.push_back(design.mirror);
  }
  return mirrors;
}

int run_design(const Options& options) {
  check_names(options.configs);
  const auto designs = design_all(options.configs);
  if (!designs) {
    return kAnswerIsNo;
  }
  OutputFolder out(options.out);
  nlohmann::ordered_json lines = nlohmann::ordered_json::array();
  for (const Designed& design : *designs) {
    const fs::path folder = folder_of(design, designs->size());
    const auto report = mirror_report(design.mirror, design.pixel_pitch);
    out.write(folder / "profile.csv", settings::mirror_profile_csv(design.mirror.assembly.profile));
    out.write(folder / "report.json", report.dump(2) + "\n");
    lines.push_back(
        {{"mirror", design.mirror.name},
         {"out", (folder.empty() ? options.out : (fs::path(options.out) / folder).string())},
         {"pinhole_height_m", report["pinhole_height_m"]},
         {"focal_px", report["focal_px"]},
         {"blind_zone_m", report["blind_zone_m"]},
         {"floor", report["floor"]}});
  }
  const auto mirrors = mirrors_of(*designs);
  out.write("profile.svg", plot::to_svg(profile_figure(mirrors)));
  out.write("ground_distance.svg", plot::to_svg(distance_figure(mirrors)));
  out.write("pixel_error.svg", plot::to_svg(pixel_error_figure(mirrors)));
  out.publish();
  for (const auto& line : lines) {
    std::cout << line.dump() << '\n';
  }
  return kDone;
}

int run_trace(const Options& options) {
  const auto designs = design_all(options.configs);
  if (!designs) {
    return kAnswerIsNo;
  }
  bool all_on_mirror = true;
  for (const Designed& design : *designs) {
    for (const double radius : options.pixel_radii) {
      const auto line = trace_report(design.mirror, radius, options.distances_m);
      all_on_mirror = all_on_mirror && !line["part"].is_null();
      std::cout << line.dump() << '\n';
    }
  }
  return all_on_mirror ? kDone : kAnswerIsNo;
}

void add_configs(CLI::App& command, Options& options) {
  command.add_option("--config", options.configs, "mirror files; several are drawn side by side")
      ->required()
      ->type_name("M.textproto");
}

}  // namespace

void add_mirror_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* mirror = app.add_subcommand("mirror", "Designs mirrors and says what they see.");
  mirror->require_subcommand(1);

  CLI::App* design = mirror->add_subcommand(
      "design", "Writes profile.csv, report.json and drawings. Exit 1: a design does not close.");
  add_configs(*design, *options);
  design->add_option("--out", options->out, "folder for the files")->required()->type_name("DIR");
  design->callback([options, &exit_code] { exit_code = run_design(*options); });

  CLI::App* trace = mirror->add_subcommand(
      "trace", "Says what pixels see, as JSON lines. Exit 1: a pixel lies beside the mirror.");
  add_configs(*trace, *options);
  trace->add_option("--pixel-radius", options->pixel_radii, "distances from the image centre, px")
      ->required()
      ->check(CLI::Range(0.0, 1e5))
      ->type_name("R");
  trace->add_option("--distance-m", options->distances_m, "where to say the ray's height")
      ->check(CLI::Range(0.0, 1e3))
      ->type_name("D");
  trace->callback([options, &exit_code] { exit_code = run_trace(*options); });
}

}  // namespace teamsight::tools
