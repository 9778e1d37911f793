// tools/detect_command.cpp: reads images, writes what is in them as JSON lines.
#include "tools/detect_command.hpp"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/contact_sheet.hpp"
#include "tools/frame_drawing.hpp"
#include "tools/sight_drawing.hpp"
#include "tools/unknown_field.hpp"
#include "tools/viewer.hpp"
#include "vision/camera_model.hpp"
#include "vision/colour_classes.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;

struct DetectOptions {
  std::string camera;
  std::string field;
  std::string draw;
  std::string classes;
  std::string sheet;
  std::vector<std::string> images;
};

constexpr double kBallRadius = 0.11;  // m; a ball lying on the floor is this high

const char* colour_name(BallColour colour) {
  switch (colour) {
    case BallColour::kOrange:
      return "orange";
    case BallColour::kRed:
      return "red";
    case BallColour::kYellow:
      return "yellow";
    case BallColour::kPatterned:
      return "patterned";
    case BallColour::kUnknown:
      break;
  }
  return "unknown";
}

const char* light_name(vision::Light light) {
  switch (light) {
    case vision::Light::kGood:
      return "good";
    case vision::Light::kDark:
      return "dark";
    case vision::Light::kGlare:
      return "glare";
    case vision::Light::kCovered:
      return "covered";
    case vision::Light::kUnknown:
      break;
  }
  return "unknown";
}

// Covariance of a ball on the floor, x and y in R, from that of its direction.
std::vector<double> floor_covariance(const BallRay& ball, const Point<Robot>& p_RB) {
  const double distance = std::hypot(p_RB.x, p_RB.y);
  const double height = ball.ray_R.origin.z - kBallRadius;
  const double along =
      (distance * distance + height * height) / height;  // d distance / d elevation
  const Eigen::Vector2d away = p_RB.vector() / std::max(distance, 1e-6);
  const Eigen::Vector2d across{-away.y(), away.x()};
  const Eigen::Matrix2d cov =
      along * along * ball.cov_direction(1, 1) * away * away.transpose() +
      distance * distance * ball.cov_direction(0, 0) * across * across.transpose();
  return {cov(0, 0), cov(0, 1), cov(1, 0), cov(1, 1)};
}

ordered_json positive_or_null(double value) {
  return value > 0.0 ? ordered_json(value) : ordered_json();
}

ordered_json ball_entry(const vision::FrameObservation& seen, std::size_t i) {
  const BallRay& ball = seen.balls[i];
  const vision::BallPixels& pixels = seen.ball_pixels[i];
  const vision::BallRange& range = seen.ball_ranges[i];
  const auto p_RB = vision::meet_plane(ball.ray_R, kBallRadius);
  ordered_json entry;
  entry["u_px"] = pixels.u_px;
  entry["v_px"] = pixels.v_px;
  entry["r_px"] = pixels.r_px;
  entry["colour"] = colour_name(ball.colour);
  entry["confidence"] = ball.confidence;
  entry["x_m"] = p_RB ? ordered_json(p_RB->x) : ordered_json();
  entry["y_m"] = p_RB ? ordered_json(p_RB->y) : ordered_json();
  entry["z_m"] = p_RB ? ordered_json(kBallRadius) : ordered_json();
  entry["cov"] = p_RB ? ordered_json(floor_covariance(ball, *p_RB)) : ordered_json();
  entry["range_on_floor_m"] = positive_or_null(range.on_floor);
  entry["sigma_range_on_floor_m"] = positive_or_null(range.sigma_on_floor);
  entry["range_by_size_m"] = positive_or_null(range.by_size);
  entry["sigma_range_by_size_m"] = positive_or_null(range.sigma_by_size);
  entry["flying_log_odds"] = range.flying_log_odds;
  return entry;
}

const char* class_name(vision::ColourClass colour) {
  switch (colour) {
    case vision::ColourClass::kBlue:
      return "blue";
    case vision::ColourClass::kYellow:
      return "yellow";
    case vision::ColourClass::kMagenta:
      return "magenta";
    case vision::ColourClass::kCyan:
      return "cyan";
    case vision::ColourClass::kRed:
      return "red";
    case vision::ColourClass::kWhite:
      return "white";
    default:
      return nullptr;
  }
}

ordered_json name_or_null(const char* name) {
  return name == nullptr ? ordered_json() : ordered_json(name);
}

ordered_json goal_entry(const vision::SeenGoal& goal) {
  ordered_json entry;
  entry["colour"] = name_or_null(class_name(goal.colour));
  entry["azimuth_rad"] = goal.azimuth;
  entry["left_rad"] = goal.left;
  entry["right_rad"] = goal.right;
  entry["distance_m"] = goal.distance ? ordered_json(*goal.distance) : ordered_json();
  return entry;
}

ordered_json obstacle_entry(const ObstacleSighting& obstacle, const vision::ObstaclePixels& foot) {
  ordered_json entry;
  entry["u_px"] = foot.u_px;
  entry["v_px"] = foot.v_px;
  entry["azimuth_rad"] = std::atan2(obstacle.p_RO.y, obstacle.p_RO.x);
  entry["distance_m"] = std::hypot(obstacle.p_RO.x, obstacle.p_RO.y);
  entry["width_m"] = obstacle.width;
  entry["team"] = name_or_null(class_name(foot.shirt));
  entry["confidence"] = obstacle.confidence;
  entry["kind"] = foot.kind == vision::ObstacleKind::kRobot ? "robot" : "legs";
  return entry;
}

ordered_json detection_line(const std::string& image, const Viewed& viewed) {
  const vision::FrameObservation& seen = *viewed.seen;
  ordered_json line;
  line["image"] = image;
  line["balls"] = ordered_json::array();
  for (std::size_t i = 0; i < seen.balls.size(); ++i) {
    line["balls"].push_back(ball_entry(seen, i));
  }
  line["obstacles"] = ordered_json::array();
  for (std::size_t i = 0; i < seen.obstacles.size(); ++i) {
    line["obstacles"].push_back(obstacle_entry(seen.obstacles[i], seen.obstacle_pixels[i]));
  }
  line["goals"] = ordered_json::array();
  for (const vision::SeenGoal& goal : seen.goals) line["goals"].push_back(goal_entry(goal));
  line["free_space"] = ordered_json::array();
  for (const vision::FreeSpace& free : seen.free_space) {
    line["free_space"].push_back({{"azimuth_rad", free.azimuth}, {"distance_m", free.distance}});
  }
  line["sensors"] = ordered_json::object();
  for (const vision::SensorValue& sensor : seen.sensors)
    line["sensors"][sensor.name] = sensor.value;
  line["light"] = light_name(seen.light);
  line["time_ms"] = viewed.time_ms;
  return line;
}

/// Drawings of what was found, where they are asked for.
class Drawings {
 public:
  Drawings(const DetectOptions& options,
           const vision::CameraParameters& camera,
           const FieldModel& field)
      : options_(options),
        camera_(camera),
        field_(field),
        colours_(camera.colours) {
    if (!options.sheet.empty()) sheets_.emplace(options.sheet);
    if (!options.classes.empty()) std::filesystem::create_directories(options.classes);
  }

  void add(const std::filesystem::path& image, const Viewed& viewed) {
    const Shot shot{image, viewed.frame, camera_.sensors};
    if (!options_.draw.empty()) draw_sight(options_.draw, shot, field_, *viewed.seen);
    if (sheets_) sheets_->add(marked_frame(shot, *viewed.seen), image.filename().string());
    for (const std::string& folder : {options_.draw, options_.classes}) {
      if (!folder.empty()) draw_classes(folder, image, viewed);
    }
  }

  void finish() {
    if (sheets_) sheets_->finish();
  }

 private:
  void draw_classes(const std::filesystem::path& folder,
                    const std::filesystem::path& image,
                    const Viewed& viewed) const {
    write_picture(folder / (image.stem().string() + "-classes.png"),
                  class_picture(viewed.frame, colours_));
  }

  const DetectOptions& options_;
  const vision::CameraParameters& camera_;
  const FieldModel& field_;
  vision::ColourClasses colours_;
  std::optional<ContactSheets> sheets_;
};

int detect(const DetectOptions& options) {
  const auto camera = settings::load_camera(options.camera);
  const bool has_field = !options.field.empty();
  const FieldModel field = has_field ? settings::load_field(options.field) : unknown_field();
  std::vector<std::filesystem::path> images;
  for (const std::string& path : options.images) {
    const auto found = images_in(path);
    images.insert(images.end(), found.begin(), found.end());
  }
  Viewer viewer(camera, field);
  Drawings drawings(options, camera, field);
  for (const std::filesystem::path& image : images) {
    const Viewed viewed = viewer.look(image, {});
    std::cout << detection_line(image.string(), viewed).dump() << std::endl;
    drawings.add(image, viewed);
  }
  drawings.finish();
  return 0;
}

}  // namespace

void add_detect_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DetectOptions>();
  CLI::App* command = app.add_subcommand("detect", "Finds balls, obstacles and free space");
  command->add_option("--camera", options->camera, "camera file")->required();
  command->add_option("--field", options->field, "field file; drops what stands off the carpet");
  command->add_option(
      "--draw",
      options->draw,
      "folder for an SVG and PNGs of each image, one with its pixels' colour classes");
  command->add_option(
      "--classes", options->classes, "folder for each image beside its pixels' colour classes");
  command->add_option(
      "--sheet", options->sheet, "folder for contact sheets of all images with what was found");
  command
      ->add_option(
          "images", options->images, "pictures, .raw dumps of the camera, or folders of them")
      ->required();
  command->callback([options, &exit_code] { exit_code = detect(*options); });
}

}  // namespace teamsight::tools
