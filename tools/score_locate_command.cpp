// tools/score_locate_command.cpp: `teamsight score locate`; see tools/score_command.hpp.
#include <cmath>
#include <cstdint>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/locate_score/cases.hpp"
#include "bench/locate_score/paper.hpp"
#include "process/program.hpp"
#include "settings/load.hpp"
#include "tools/output_folder.hpp"
#include "tools/score_command.hpp"
#include "tools/score_histogram.hpp"
#include "vision/image.hpp"
#include "vision/resized_camera.hpp"

namespace teamsight::tools {

namespace {

using locate_score::CaseOptions;
using locate_score::CaseResult;
using locate_score::Tally;
using nlohmann::ordered_json;

constexpr double kDegrees = 57.29577951308232;
constexpr std::uint32_t kLeastSide = 120;  // px; below, a line is no wider than a pixel
constexpr std::uint32_t kMostSide = 4096;  // px

struct ScoreLocateOptions {
  std::string camera{"config/cameras/sim-640.textproto"};
  std::string field{"config/fields/msl-2024.textproto"};
  std::string other_field{"config/fields/kassel-lab.textproto"};
  std::string paper_field{"config/fields/robocup-2001.textproto"};
  std::vector<std::string> cases{"noise", "hardware", "faults", "drive", "paper"};
  std::vector<std::uint32_t> size;
  std::size_t poses{1000};
  std::uint32_t seed{1};
  bool without_rivals{false};
  std::string draw;
};

ordered_json rounded(double value) {
  return std::round(value * 1e4) / 1e4;
}

ordered_json rounded(const std::optional<double>& value) {
  return value ? rounded(*value) : ordered_json();
}

ordered_json json_of(const CaseResult& result, const std::string& method, const Tally& tally) {
  const auto interval = locate_score::wilson(tally.failures(), tally.count());
  const Eigen::Vector3d mean = tally.mean();
  const Eigen::Vector3d deviation = tally.deviation();
  ordered_json line;
  line["case"] = result.name;
  line["detail"] = result.detail;
  line["method"] = method;
  line["poses"] = tally.count();
  line["median_m"] = rounded(tally.place_quantile(0.5));
  line["rms_m"] = rounded(tally.place_rms());
  line["p95_m"] = rounded(tally.place_quantile(0.95));
  line["worst_m"] = rounded(tally.place_quantile(1.0));
  line["rms_deg"] = rounded(kDegrees * tally.turn_rms());
  line["failures"] = tally.failures();
  line["no_answer"] = tally.silent();
  line["failure_rate_95"] = {rounded(interval.low), rounded(interval.high)};
  line["nees"] = rounded(tally.nees());
  line["ratio_to_bound"] = rounded(tally.bound_ratio());
  line["ratio_to_bound_heading"] = rounded(tally.turn_bound_ratio());
  line["mean_m_m_deg"] = {rounded(mean.x()), rounded(mean.y()), rounded(kDegrees * mean.z())};
  line["std_m_m_deg"] = {
      rounded(deviation.x()), rounded(deviation.y()), rounded(kDegrees * deviation.z())};
  line["time_ms_min"] = rounded(tally.time_least());
  line["time_ms_median"] = rounded(tally.time_quantile(0.5));
  return line;
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:8.2f}", *value) : std::string(8, ' ');
}

void print(const CaseResult& result, const locate_score::PointErrors& points) {
  ordered_json line;
  line["case"] = result.name;
  line["detail"] = "line points";
  line["frames"] = points.frames();
  line["per_frame"] = rounded(points.points_per_frame());
  line["off_paint_share"] = rounded(points.share_off_paint());
  line["median_mm"] = rounded(1e3 * points.quantile(0.5));
  line["rms_mm"] = rounded(1e3 * points.rms());
  line["p95_mm"] = rounded(1e3 * points.quantile(0.95));
  line["over_claimed"] = rounded(points.over_claimed());
  std::cout << line.dump() << std::endl;
  std::cerr << fmt::format(
      "line points: {:.0f} a frame, {:.2f} % off the paint; distance {:.1f} mm in the median, "
      "{:.1f} RMS, 95 % within {:.1f}; {} of what is claimed\n",
      points.points_per_frame(),
      100.0 * points.share_off_paint(),
      1e3 * points.quantile(0.5),
      1e3 * points.rms(),
      1e3 * points.quantile(0.95),
      cell(points.over_claimed()));
}

void print(const CaseResult& result) {
  std::cerr << fmt::format(
      "\n{} {}\n{:18} {:>6} {:>9} {:>8} {:>8} {:>9} {:>8} {:>15} {:>8} {:>8} {:>9}\n",
      result.name,
      result.detail,
      "method",
      "poses",
      "median mm",
      "RMS mm",
      "95 % mm",
      "worst mm",
      "RMS deg",
      "failed %",
      "NEES",
      "x bound",
      "ms");
  for (const auto& [method, tally] : result.tallies) {
    std::cout << json_of(result, method, tally).dump() << std::endl;
    const auto interval = locate_score::wilson(tally.failures(), tally.count());
    std::cerr << fmt::format(
        "{:18} {:6} {:9.1f} {:8.1f} {:8.1f} {:9.1f} {:8.3f} {:4.1f} ({:.1f}-{:.1f}) {} {} "
        "{:9.3f}\n",
        method,
        tally.count(),
        1e3 * tally.place_quantile(0.5),
        1e3 * tally.place_rms(),
        1e3 * tally.place_quantile(0.95),
        1e3 * tally.place_quantile(1.0),
        kDegrees * tally.turn_rms(),
        tally.count() == 0
            ? 0.0
            : 100.0 * static_cast<double>(tally.failures()) / static_cast<double>(tally.count()),
        100.0 * interval.low,
        100.0 * interval.high,
        cell(tally.nees()),
        cell(tally.bound_ratio()),
        tally.time_quantile(0.5));
  }
  if (result.points) print(result, *result.points);
}

locate_score::Recoveries recoveries_of(const locate_score::DriveResult& drive,
                                       const std::string& method) {
  const auto found = drive.recoveries.find(method);
  return found == drive.recoveries.end() ? locate_score::Recoveries{} : found->second;
}

void print(const locate_score::DriveResult& drive) {
  print(drive.frames);
  ordered_json line;
  line["case"] = "drive";
  line["detail"] = "events";
  line["sequences"] = drive.sequences;
  line["kidnappings"] = drive.kidnappings;
  const locate_score::Recoveries own = recoveries_of(drive, "track");
  line["found_within_1s"] = own.within_1s;
  line["slowest_s"] = rounded(own.slowest_s);
  for (const auto& [method, recoveries] : drive.recoveries) {
    line["found_within_1s_by"][method] = recoveries.within_1s;
  }
  line["wrong_halves"] = drive.wrong_halves;
  line["halves_repaired_within_5s"] = drive.halves_repaired;
  line["false_ok_over_0.3s"] = drive.false_ok_episodes;
  line["longest_false_ok_s"] = rounded(drive.longest_false_ok_s);
  line["slips_noticed"] = drive.slips;
  std::cout << line.dump() << std::endl;
  std::cerr << fmt::format(
      "kidnapped {}: right within 1 s {}, slowest {:.2f} s; wrong half {}: repaired {}; ok while "
      "wrong for over 0.3 s: {} times, longest {:.2f} s; slips noticed {}\n",
      drive.kidnappings,
      own.within_1s,
      own.slowest_s,
      drive.wrong_halves,
      drive.halves_repaired,
      drive.false_ok_episodes,
      drive.longest_false_ok_s,
      drive.slips);
  for (const auto& [method, recoveries] : drive.recoveries) {
    std::cerr << fmt::format("kidnapped, {}: right within 1 s {} of {}\n",
                             method,
                             recoveries.within_1s,
                             drive.kidnappings);
  }
}

void score_paper(const ScoreLocateOptions& options, CaseOptions cases) {
  cases.field = settings::load_field(options.paper_field);
  const CaseResult result = locate_score::run_paper(cases, {});
  print(result);
  std::cerr << "the paper's own figures, 90 images: mean 3.2 mm, -18 mm, 0.22 degrees; standard "
               "deviation 100 mm, 92 mm, 1.8 degrees; 0.5 s an image\n";
  if (options.draw.empty()) return;
  OutputFolder folder(options.draw);
  for (const auto& [method, tally] : result.tallies) {
    if (tally.errors().empty()) continue;
    folder.write("paper-" + method + ".svg", error_histogram(method, tally));
  }
  folder.publish();
}

vision::CameraParameters camera_of(const ScoreLocateOptions& options) {
  vision::CameraParameters camera = settings::load_camera(options.camera);
  if (options.size.empty()) return camera;
  const std::uint32_t width_px = options.size[0];
  const std::uint32_t height_px = options.size[1];
  if (!vision::has_even_size(camera.format, width_px, height_px)) {
    throw std::runtime_error(
        fmt::format("--size: found {} {}, expected even numbers of pixels", width_px, height_px));
  }
  return vision::resized(camera, width_px, height_px);
}

int score_locate(const ScoreLocateOptions& options) {
  CaseOptions cases;
  cases.camera = camera_of(options);
  cases.field = settings::load_field(options.field);
  cases.other_field = settings::load_field(options.other_field);
  cases.poses = options.poses;
  cases.seed = options.seed;
  cases.rivals = !options.without_rivals;
  for (const std::string& name : options.cases) {
    if (name == "noise") {
      print(locate_score::run_drawn_noise(cases));
      print(locate_score::run_noise(cases));
    }
    if (name == "hardware") print(locate_score::run_hardware(cases, {}));
    if (name == "faults") {
      for (const CaseResult& result : locate_score::run_faults(cases, {})) print(result);
    }
    if (name == "drive") print(locate_score::run_drives(cases, {}));
    if (name == "paper") score_paper(options, cases);
  }
  return process::kDone;
}

}  // namespace

void add_score_locate_command(CLI::App& score, int& exit_code) {
  auto options = std::make_shared<ScoreLocateOptions>();
  CLI::App* command = score.add_subcommand(
      "locate", "Self-localisation on rendered frames, beside bounds and other methods");
  command->add_option("--camera", options->camera, "camera file, YUYV or UYVY");
  command
      ->add_option("--size", options->size, "of the pictures, px: the same eye with another sensor")
      ->type_name("WIDTH HEIGHT")
      ->expected(2)
      ->check(CLI::Range(kLeastSide, kMostSide));
  command->add_option("--field", options->field, "field file");
  command->add_option("--other-field", options->other_field, "field file of another size");
  command->add_option(
      "--paper-field", options->paper_field, "field file of the paper's experiment");
  command->add_option("--case", options->cases, "which cases")
      ->check(CLI::IsMember({"noise", "hardware", "faults", "drive", "paper"}));
  command->add_option("--poses", options->poses, "of each case")
      ->check(CLI::Range(std::size_t{20}, std::size_t{1000000}));
  command->add_option("--seed", options->seed, "of poses, noise and faults");
  command->add_flag("--without-rivals", options->without_rivals, "only the product");
  command->add_option("--draw", options->draw, "folder for histograms of the paper's experiment");
  command->callback([options, &exit_code] { exit_code = score_locate(*options); });
}

}  // namespace teamsight::tools
