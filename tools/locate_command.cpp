// tools/locate_command.cpp: reads images, writes postures as JSON lines.
#include "tools/locate_command.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/number_list.hpp"
#include "tools/sight_drawing.hpp"
#include "tools/viewer.hpp"
#include "vision/hough2001/hough2001.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;

constexpr int kNo = 1;
constexpr double kPriorSigma = 0.5;          // m, of a place given by hand
constexpr double kPriorSigmaHeading = 0.35;  // rad

struct LocateOptions {
  std::string camera;
  std::string field;
  std::string method{"track"};
  std::string prior;
  std::string draw;
  std::vector<std::string> images;
};

vision::MotionPrior prior_of(const LocateOptions& options) {
  vision::MotionPrior prior;
  if (options.method == "global" || options.prior.empty()) return prior;
  const std::vector<double> pose = read_numbers("--prior", options.prior, 3);
  prior.X_FR = Pose<Field, Robot>(pose[0], pose[1], pose[2]);
  prior.cov = Eigen::Vector3d(kPriorSigma * kPriorSigma,
                              kPriorSigma * kPriorSigma,
                              kPriorSigmaHeading * kPriorSigmaHeading)
                  .asDiagonal();
  // Who names a place also means this half.
  prior.half_log_odds = vision::kMaxHalfLogOdds;
  return prior;
}

const char* status_name(PostureStatus status) {
  switch (status) {
    case PostureStatus::kOk:
      return "ok";
    case PostureStatus::kAmbiguous:
      return "ambiguous";
    case PostureStatus::kLost:
      break;
  }
  return "lost";
}

// The median distance of the inliers from the paint; null when lost.
ordered_json median_residual(const vision::FrameObservation& seen) {
  std::vector<double> inliers;
  for (std::size_t i = 0; i < seen.line_fits.size(); ++i) {
    if (seen.line_fits[i]) inliers.push_back(std::abs(seen.line_residuals[i]));
  }
  if (inliers.empty()) return nullptr;
  const auto middle = inliers.begin() + static_cast<std::ptrdiff_t>(inliers.size() / 2);
  std::nth_element(inliers.begin(), middle, inliers.end());
  return *middle;
}

ordered_json posture_line(const std::string& image, const Viewed& viewed) {
  const PostureEstimate& posture = viewed.seen->posture;
  const bool is_lost = posture.status == PostureStatus::kLost;
  ordered_json line;
  line["image"] = image;
  line["method"] = viewed.seen->searched_globally ? "global" : "track";
  line["status"] = status_name(posture.status);
  line["x_m"] = is_lost ? ordered_json() : ordered_json(posture.X_FR.x());
  line["y_m"] = is_lost ? ordered_json() : ordered_json(posture.X_FR.y());
  line["theta_rad"] = is_lost ? ordered_json() : ordered_json(posture.X_FR.theta());
  line["cov"] = nullptr;
  if (!is_lost) {
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> cov = posture.cov;
    line["cov"] = std::vector<double>(cov.data(), cov.data() + 9);
  }
  line["half_log_odds"] = is_lost ? ordered_json() : ordered_json(posture.half_log_odds);
  line["points"] = posture.line_points;
  line["inlier_ratio"] = posture.inlier_ratio;
  line["median_residual_m"] = median_residual(*viewed.seen);
  line["time_ms"] = viewed.time_ms;
  return line;
}

// What the founding paper's method says; it has neither covariance nor odds.
ordered_json hough_line(const std::string& image,
                        const vision::Hough2001Result& found,
                        double time_ms) {
  const bool is_lost = found.status == PostureStatus::kLost;
  ordered_json line;
  line["image"] = image;
  line["method"] = "hough2001";
  line["status"] = status_name(found.status);
  line["x_m"] = is_lost ? ordered_json() : ordered_json(found.X_FR.x());
  line["y_m"] = is_lost ? ordered_json() : ordered_json(found.X_FR.y());
  line["theta_rad"] = is_lost ? ordered_json() : ordered_json(found.X_FR.theta());
  line["cov"] = nullptr;
  line["half_log_odds"] = nullptr;
  line["points"] = found.transitions;
  line["inlier_ratio"] = nullptr;
  line["matches"] = found.matches;
  line["time_ms"] = time_ms;
  return line;
}

int locate_as_in_2001(const LocateOptions& options) {
  vision::CameraParameters camera = settings::load_camera(options.camera);
  const FieldModel field = settings::load_field(options.field);
  std::optional<vision::Hough2001> method;
  int exit_code = 0;
  for (const std::string& image : options.images) {
    const ImageFile frame = read_image(image, camera);
    if (!method || frame.format != camera.format) {
      camera.format = frame.format;
      method.emplace(camera, field);
    }
    const auto start = std::chrono::steady_clock::now();
    const vision::Hough2001Result found = method->locate(frame.view());
    const auto elapsed = std::chrono::steady_clock::now() - start;
    const double time_ms = std::chrono::duration<double, std::milli>(elapsed).count();
    std::cout << hough_line(image, found, time_ms).dump() << std::endl;
    if (found.status == PostureStatus::kLost) exit_code = kNo;
  }
  return exit_code;
}

int locate(const LocateOptions& options) {
  if (options.method == "hough2001") return locate_as_in_2001(options);
  const auto camera = settings::load_camera(options.camera);
  const FieldModel field = settings::load_field(options.field);
  const vision::MotionPrior prior = prior_of(options);
  Viewer viewer(camera, field);
  int exit_code = 0;
  for (const std::string& image : options.images) {
    const Viewed viewed = viewer.look(image, prior);
    std::cout << posture_line(image, viewed).dump() << std::endl;
    if (!options.draw.empty())
      draw_sight(options.draw, {image, viewed.frame, {}}, field, *viewed.seen);
    if (viewed.seen->posture.status == PostureStatus::kLost) exit_code = kNo;
  }
  return exit_code;
}

}  // namespace

void add_locate_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<LocateOptions>();
  CLI::App* command = app.add_subcommand("locate", "Finds where the robot stood, from line points");
  command->add_option("--camera", options->camera, "camera file")->required();
  command->add_option("--field", options->field, "field file")->required();
  command
      ->add_option(
          "--method",
          options->method,
          "track: from the prior, else global; global: always; hough2001: the founding paper's")
      ->check(CLI::IsMember({"track", "global", "hough2001"}));
  command->add_option("--prior", options->prior, "x_m,y_m,theta_rad");
  command->add_option("--draw", options->draw, "folder for an SVG and a PNG of each image");
  command->add_option("images", options->images, "pictures, or .raw dumps of the camera")
      ->required();
  command->callback([options, &exit_code] { exit_code = locate(*options); });
}

}  // namespace teamsight::tools
