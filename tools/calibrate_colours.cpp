// tools/calibrate_colours.cpp: colour classes from labelled pixels and from the field's own light.
#include "tools/calibrate_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/image_file.hpp"
#include "tools/number_list.hpp"
#include "tools/unknown_field.hpp"
#include "vision/calibration/class_training.hpp"
#include "vision/calibration/colour_samples.hpp"
#include "vision/calibration/cube_training.hpp"
#include "vision/field_colours.hpp"
#include "vision/perception.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;
using vision::ColourClass;

constexpr int kNo = 1;
constexpr double kClickRadius = 2.0;  // px around a clicked pixel
constexpr double kDegree = std::numbers::pi / 180.0;

struct ColourOptions {
  std::string base;
  std::string out;
  std::string labels;
  std::vector<std::string> samples;
  std::string image;
  bool balance{false};
  bool light{false};
  bool table{false};
  bool cube{false};
  std::vector<std::string> teach;
};

/// One place in an image that shows a class.
struct Click {
  std::string image;
  ColourClass colour{ColourClass::kNone};
  vision::Pixel place;
  double radius_px{kClickRadius};
};

constexpr std::array<std::pair<std::string_view, ColourClass>, 9> kNames{
    {{"GREEN", ColourClass::kGreen},
     {"BALL", ColourClass::kBall},
     {"BLUE", ColourClass::kBlue},
     {"YELLOW", ColourClass::kYellow},
     {"MAGENTA", ColourClass::kMagenta},
     {"CYAN", ColourClass::kCyan},
     {"RED", ColourClass::kRed},
     {"WHITE", ColourClass::kWhite},
     {"BLACK", ColourClass::kBlack}}};

ColourClass class_named(const std::string& where, std::string_view name) {
  for (const auto& [known, colour] : kNames) {
    if (known == name) return colour;
  }
  throw std::runtime_error(where + ": found class \"" + std::string(name) +
                           "\", expected one of GREEN, BALL, BLUE, YELLOW, MAGENTA, CYAN, RED, "
                           "WHITE, BLACK");
}

std::string_view name_of(ColourClass colour) {
  for (const auto& [known, value] : kNames) {
    if (value == colour) return known;
  }
  return "NONE";
}

// CLASS:u_px,v_px or CLASS:u_px,v_px,radius_px
Click click_of(const std::string& text, const std::string& image) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos || image.empty()) {
    throw std::runtime_error("--sample: found \"" + text +
                             "\", expected CLASS:u_px,v_px[,radius_px] and --image");
  }
  const std::vector<double> numbers = read_numbers("--sample", text.substr(colon + 1));
  if (numbers.size() != 2 && numbers.size() != 3) {
    throw std::runtime_error("--sample: found \"" + text +
                             "\", expected two or three numbers after the class");
  }
  Click click{image, class_named("--sample", text.substr(0, colon)), {numbers[0], numbers[1]}};
  if (numbers.size() == 3) click.radius_px = numbers[2];
  return click;
}

// [{"image": FILE, "class": NAME, "u_px": N, "v_px": N, "r_px": N}, ...]
std::vector<Click> clicks_in(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": found no readable file, expected JSON");
  std::vector<Click> clicks;
  try {
    for (const auto& entry : nlohmann::json::parse(file)) {
      clicks.push_back({entry.at("image").get<std::string>(),
                        class_named(path, entry.at("class").get<std::string>()),
                        {entry.at("u_px").get<double>(), entry.at("v_px").get<double>()},
                        entry.value("r_px", kClickRadius)});
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(path + ": found " + error.what() +
                             ", expected a list of image, class, u_px, v_px and r_px");
  }
  return clicks;
}

vision::LabelledColours pixels_at(const Click& click, const vision::CameraParameters& camera) {
  const ImageFile frame = read_image(click.image, camera);
  auto pixels = vision::colours_around(frame.view(), click.place, click.radius_px);
  if (pixels.empty()) {
    throw std::runtime_error(click.image + ": found a sample beside the image, expected one in it");
  }
  return {click.colour, std::move(pixels)};
}

ordered_json cube_report(const vision::CubeParameters& cube) {
  ordered_json report;
  report["planes"] = ordered_json::array();
  for (const vision::CubePlane& plane : cube.planes) {
    report["planes"].push_back({{"red", plane.red},
                                {"green", plane.green},
                                {"blue", plane.blue},
                                {"threshold", plane.threshold}});
  }
  report["vertices"] = ordered_json::array();
  for (const ColourClass colour : cube.classes) report["vertices"].push_back(name_of(colour));
  return report;
}

ordered_json report(const vision::ColourParameters& colours) {
  ordered_json line;
  line["white_min_y"] = colours.white_min_y;
  line["black_max_y"] = colours.black_max_y;
  if (colours.light) {
    const auto& [green, white] = *colours.light;
    line["light"] = {{"green", {green.y, green.u, green.v}},
                     {"white", {white.y, white.u, white.v}}};
  }
  line["samples"] = ordered_json::array();
  for (const vision::ColourSample& sample : colours.samples) {
    line["samples"].push_back({{"class", name_of(sample.colour)},
                               {"u", sample.u},
                               {"v", sample.v},
                               {"radius", sample.radius}});
  }
  line["hues"] = ordered_json::array();
  for (const vision::HueSector& sector : colours.sectors) {
    line["hues"].push_back({{"class", name_of(sector.colour)},
                            {"from_deg", std::round(sector.from / kDegree)},
                            {"to_deg", std::round(sector.to / kDegree)},
                            {"min_chroma", sector.min_chroma}});
  }
  if (colours.cube) line["cube"] = cube_report(*colours.cube);
  return line;
}

// The classes of the base, carried over to the light of the image.
std::optional<vision::ColourParameters> balanced(const vision::CameraParameters& camera,
                                                 const std::string& image) {
  if (image.empty()) throw std::runtime_error("--balance: found no --image, expected one");
  const ImageFile frame = read_image(image, camera);
  const vision::CameraModel model(camera);
  const double outer =
      std::min(camera.mask.outer_radius_px, 0.5 * std::min(camera.width_px, camera.height_px));
  const auto now =
      vision::field_colours(frame.view(), model.centre(), camera.mask.inner_radius_px, outer);
  if (!now) {
    std::cerr << "teamsight: " << image << ": neither carpet nor paint stands out\n";
    return std::nullopt;
  }
  return vision::balanced(camera.colours, *now);
}

// What the field looks like in the image, measured as the agent does.
std::optional<vision::FieldColours> light_in(vision::CameraParameters camera,
                                             const std::string& image) {
  if (image.empty()) throw std::runtime_error("--light: found no --image, expected one");
  const ImageFile frame = read_image(image, camera);
  camera.format = frame.format;
  const auto found = vision::Perception(camera, unknown_field()).field_colours(frame.view());
  if (found && !vision::is_saturated(found->white)) return found;
  std::cerr << "teamsight: " << image << ": carpet and paint do not stand out, or are too bright\n";
  return std::nullopt;
}

// By the method that is asked for: discs and hues, a table, or the planes of a cube. Else why not.
Result<vision::ColourParameters, std::string> taught(
    const vision::ColourParameters& before,
    const std::vector<vision::LabelledColours>& labels,
    const ColourOptions& options) {
  vision::ColourParameters colours = before;
  if (options.cube) {
    colours.method = vision::ColourMethod::kCube;
    colours.cube = vision::train_cube(labels);
    if (!colours.cube) {
      return tl::make_unexpected(
          std::string("a cube needs samples of GREEN, WHITE and BLACK, and a vertex for the ball"));
    }
  } else if (options.table) {
    colours.method = vision::ColourMethod::kTable;
    colours.table = vision::train_classes(before, labels);
  } else if (!labels.empty()) {
    const auto found = vision::colours_from(before, labels);
    if (!found) {
      return tl::make_unexpected(std::string(name_of(found.error().a)) + " and " +
                                 std::string(name_of(found.error().b)) +
                                 " look the same in this light: no border between them");
    }
    colours = *found;
  }
  return colours;
}

// The classes of the base, with the light and the balance that are asked for; nothing: the image
// shows no field.
std::optional<vision::ColourParameters> colours_in_light(const vision::CameraParameters& camera,
                                                         const ColourOptions& options) {
  vision::ColourParameters colours = camera.colours;
  const bool has_samples = !options.labels.empty() || !options.samples.empty();
  const bool is_plain = vision::method_of(colours) == vision::ColourMethod::kSamples;
  const bool makes_discs = has_samples && !options.table && !options.cube;
  if (!is_plain && (options.balance || makes_discs)) {
    throw std::runtime_error(
        options.base +
        ": found a trained table or a cube, expected --sample or --labels with --table or --cube");
  }
  if (options.balance) {
    const auto found = balanced(camera, options.image);
    if (!found) return std::nullopt;
    colours = *found;
  }
  if (options.balance || options.light) {
    colours.light = light_in(camera, options.image);
    if (!colours.light) return std::nullopt;
  }
  return colours;
}

// All places that are clicked, and what the base's classes say of the pictures that teach.
std::vector<vision::LabelledColours> labels_of(const vision::CameraParameters& camera,
                                               const ColourOptions& options) {
  std::vector<Click> clicks;
  if (!options.labels.empty()) clicks = clicks_in(options.labels);
  for (const std::string& text : options.samples) clicks.push_back(click_of(text, options.image));
  std::vector<vision::LabelledColours> labels;
  labels.reserve(clicks.size());
  for (const Click& click : clicks) labels.push_back(pixels_at(click, camera));
  for (const std::string& image : options.teach) {
    const ImageFile frame = read_image(image, camera);
    auto places = vision::labelled_by_classes(frame.view(), camera);
    std::move(places.begin(), places.end(), std::back_inserter(labels));
  }
  return labels;
}

int calibrate_colours(const ColourOptions& options) {
  if (options.table && options.cube) {
    throw std::runtime_error("found --table and --cube, expected one of them");
  }
  if (!options.teach.empty() && !options.cube) {
    throw std::runtime_error("found --teach without --cube, expected both");
  }
  vision::CameraParameters camera = settings::load_camera(options.base);
  const auto in_light = colours_in_light(camera, options);
  if (!in_light) return kNo;
  camera.colours = *in_light;
  const std::vector<vision::LabelledColours> labels = labels_of(camera, options);
  if (labels.empty() && !options.balance && !options.light) {
    throw std::runtime_error(
        "found neither --sample, --labels, --teach, --balance nor --light, expected one of them");
  }
  const auto colours = taught(camera.colours, labels, options);
  if (!colours) {
    std::cerr << "teamsight: " << colours.error() << '\n';
    return kNo;
  }
  camera.colours = *colours;
  std::cout << report(camera.colours).dump() << std::endl;
  if (!options.out.empty()) {
    settings::save_camera(options.out, camera, "Colours: teamsight calibrate colours");
  }
  return 0;
}

}  // namespace

void add_calibrate_colours(CLI::App& calibrate, int& exit_code) {
  auto options = std::make_shared<ColourOptions>();
  CLI::App* colours = calibrate.add_subcommand(
      "colours", "Colour classes from labelled pixels. Exit 1: two classes look the same");
  colours->add_option("--base,--camera", options->base, "camera file to start from")->required();
  colours->add_option("--image", options->image, "picture or .raw dump of the samples");
  colours->add_option("--sample", options->samples, "CLASS:u_px,v_px[,radius_px] in the image");
  colours->add_option("--labels", options->labels, "JSON list of image, class, u_px, v_px, r_px");
  colours->add_flag("--balance",
                    options->balance,
                    "carry the base's classes over to the image's light, by its white and green");
  colours->add_flag("--light",
                    options->light,
                    "the classes are right in the image's light: the agent follows it from there");
  colours->add_flag("--table",
                    options->table,
                    "train a table over luminance and chroma by the samples, not discs");
  colours->add_flag(
      "--cube", options->cube, "make the planes of the RGB cube by the samples, not discs");
  colours->add_option(
      "--teach", options->teach, "pictures whose pixels the base's classes label, for --cube");
  colours->add_option("--out", options->out, "camera file to write");
  colours->callback([options, &exit_code] { exit_code = calibrate_colours(*options); });
}

}  // namespace teamsight::tools
