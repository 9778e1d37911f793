// tools/calibrate_lines.cpp: drive around, press the button: a camera file from lines.
#include "tools/calibrate_lines.hpp"

#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/calibration_report.hpp"
#include "tools/line_views.hpp"
#include "tools/output_folder.hpp"
#include "tools/progress_line.hpp"
#include "vision/calibration/line_calibration.hpp"

namespace teamsight::tools {

namespace {

constexpr int kNo = 1;

struct LineOptions {
  std::string base;
  std::string field;
  std::string out;
  std::string report;
  std::vector<std::string> views;
  double sigma_px{0.3};
  double reach_m{6.0};
  double max_ground_sigma_m{0.02};
};

void write_report(const LineOptions& options, const vision::LineCalibration& result) {
  OutputFolder out(options.report);
  out.write("residuals.svg", plot::to_svg(residual_figure(result)));
  out.write("report.json", calibration_report(result, options.reach_m).dump(2) + "\n");
  out.publish();
}

int calibrate_lines(const LineOptions& options) {
  const vision::CameraParameters camera = settings::load_camera(options.base);
  const FieldModel field = settings::load_field(options.field);
  vision::LineCalibrationRules rules;
  rules.bundle.sigma_px = options.sigma_px;
  rules.bundle.max_distance = camera.scan.max_distance;
  rules.reach = options.reach_m;
  rules.max_ground_sigma = options.max_ground_sigma_m;
  LineViews views(options.views, camera, field);
  const auto result = vision::calibrate_lines(vision::LineMap(field), camera, views, rules);
  ProgressLine().clear();
  for (std::size_t i = 0; i < result.views.size(); ++i) {
    std::cout << view_report(options.views[i], result.views[i]).dump() << '\n';
  }
  std::cout << calibration_report(result, options.reach_m).dump() << std::endl;
  if (!options.report.empty()) write_report(options, result);
  if (result.refusal) {
    std::cerr << "teamsight: " << refusal_text(result, rules) << '\n';
    return kNo;
  }
  if (!options.out.empty()) {
    settings::save_camera(options.out,
                          result.camera,
                          "Geometry from " + std::to_string(result.camera.calibration->views) +
                              " views of lines: teamsight calibrate lines");
  }
  return 0;
}

}  // namespace

void add_calibrate_lines(CLI::App& calibrate, int& exit_code) {
  auto options = std::make_shared<LineOptions>();
  CLI::App* lines = calibrate.add_subcommand(
      "lines", "From images at unknown places on a known field. Exit 1: they do not determine it");
  lines->add_option("--base,--camera", options->base, "camera file to start from")->required();
  lines->add_option("--field", options->field, "field file")->required();
  lines->add_option("--out", options->out, "camera file to write");
  lines->add_option("--report", options->report, "folder for residuals.svg and report.json");
  lines->add_option("--sigma-px", options->sigma_px, "of a line point; the true one is measured")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  lines->add_option("--reach-m", options->reach_m, "floor that the camera shall know")
      ->check(CLI::Range(1.0, 30.0))
      ->capture_default_str();
  lines
      ->add_option("--max-ground-sigma-m",
                   options->max_ground_sigma_m,
                   "known worse than this over that floor: refused")
      ->check(CLI::Range(0.001, 10.0))
      ->capture_default_str();
  lines->add_option("view", options->views, "pictures, .raw dumps, or lists of line pixels (.txt)")
      ->required();
  lines->callback([options, &exit_code] { exit_code = calibrate_lines(*options); });
}

}  // namespace teamsight::tools
