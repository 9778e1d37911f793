// tools/calibrate_mask.cpp: a driving sequence shows what never moves in the picture.
#include "tools/calibrate_mask.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/image_file.hpp"
#include "vision/calibration/body_mask.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;

constexpr int kNo = 1;
constexpr double kDegrees = 180.0 / std::numbers::pi;

struct MaskOptions {
  std::string base;
  std::string out;
  std::vector<std::string> images;
};

// Where the mirror ends, in pixels from the centre.
double rim_of(const vision::CameraParameters& camera) {
  double rim = 0.5 * std::min(camera.width_px, camera.height_px);
  if (const auto* table = std::get_if<vision::RadialTable>(&camera.mirror)) {
    rim = std::min(rim, table->rows.back().radius_px);
  } else {
    const auto& mirror = std::get<vision::ProfileMirror>(camera.mirror);
    rim = std::min(rim, mirror.focal_x_px * mirror.profile.back().x / mirror.profile.back().y);
  }
  return std::min(rim, camera.mask.outer_radius_px);
}

ordered_json report(const vision::Body& body, std::size_t frames) {
  ordered_json line;
  line["frames"] = frames;
  line["inner_radius_px"] = body.inner_radius_px;
  line["hidden_share"] = body.hidden_share;
  line["patches"] = ordered_json::array();
  for (const vision::BodyPatch& patch : body.patches) {
    line["patches"].push_back({{"from_deg", kDegrees * patch.from},
                               {"to_deg", kDegrees * patch.to},
                               {"inner_px", patch.inner_px},
                               {"outer_px", patch.outer_px},
                               {"strut", patch.is_strut}});
  }
  return line;
}

// The patch's outline: along the outer circle, then back along the inner one. Chords of the outer
// circle stay inside it, so that no more floor is hidden than the patch.
vision::Polygon outline(const vision::BodyPatch& patch, const vision::Pixel& centre) {
  constexpr double kStep = 4.0 / kDegrees;
  const int steps = std::max(1, static_cast<int>(std::ceil((patch.to - patch.from) / kStep)));
  vision::Polygon polygon;
  const auto add = [&](double radius, int step) {
    const double direction = patch.from + (patch.to - patch.from) * step / steps;
    polygon.push_back(
        {centre.u + radius * std::cos(direction), centre.v - radius * std::sin(direction)});
  };
  for (int step = 0; step <= steps; ++step) add(patch.outer_px, step);
  for (int step = steps; step >= 0; --step) add(patch.inner_px, step);
  return polygon;
}

// A strut, from the body to the rim, hides its whole direction; other patches hide themselves.
vision::CameraParameters with_body(vision::CameraParameters camera,
                                   const vision::Body& body,
                                   const vision::Pixel& centre) {
  camera.mask.inner_radius_px = body.inner_radius_px;
  camera.mask.sectors.clear();
  camera.mask.polygons.clear();
  for (const vision::BodyPatch& patch : body.patches) {
    if (patch.is_strut) {
      camera.mask.sectors.push_back({patch.from, patch.to});
    } else {
      camera.mask.polygons.push_back(outline(patch, centre));
    }
  }
  return camera;
}

int calibrate_mask(const MaskOptions& options) {
  const vision::CameraParameters camera = settings::load_camera(options.base);
  const vision::CameraModel model(camera);
  vision::BodyWatch watch(model.centre(), rim_of(camera), camera.width_px, camera.height_px);
  for (const std::string& image : options.images) watch.add(read_image(image, camera).view());
  const auto body = watch.body(vision::ColourClasses(camera.colours));
  if (!body) {
    std::cerr << "teamsight: "
              << (body.error() == vision::BodyFailure::kTooFew
                      ? "fewer than ten frames: too few to tell what moves"
                      : "most of the picture never changed: drive while the frames are taken")
              << '\n';
    return kNo;
  }
  std::cout << report(*body, options.images.size()).dump() << std::endl;
  if (!options.out.empty()) {
    settings::save_camera(options.out,
                          with_body(camera, *body, model.centre()),
                          "Mask from " + std::to_string(options.images.size()) +
                              " frames of a driving robot: teamsight calibrate mask");
  }
  return 0;
}

}  // namespace

void add_calibrate_mask(CLI::App& calibrate, int& exit_code) {
  auto options = std::make_shared<MaskOptions>();
  CLI::App* mask = calibrate.add_subcommand(
      "mask", "Own body and struts, from frames of a driving robot. Exit 1: it stood still");
  mask->add_option("--base,--camera", options->base, "camera file to start from")->required();
  mask->add_option("--out", options->out, "camera file to write");
  mask->add_option("image", options->images, "pictures or .raw dumps, ten or more")->required();
  mask->callback([options, &exit_code] { exit_code = calibrate_mask(*options); });
}

}  // namespace teamsight::tools
