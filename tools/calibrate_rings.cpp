// tools/calibrate_rings.cpp: rings in pictures become the radial table of a camera file.
#include "tools/calibrate_rings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tools/image_file.hpp"
#include "tools/number_list.hpp"
#include "vision/ring_calibration.hpp"

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;

constexpr int kNo = 1;

struct RingOptions {
  std::string base;
  std::string out;
  std::string image;
  std::string distances;
  std::string centre;
  double inner_px{0.0};
};

std::vector<double> growing_distances(const std::string& text) {
  constexpr std::size_t kFewest = 3;  // fewer make no table
  std::vector<double> distances = read_numbers("--distances", text);
  const bool grow =
      distances.front() > 0.0 &&
      std::ranges::adjacent_find(distances, std::ranges::greater_equal()) == distances.end();
  if (!grow || distances.size() < kFewest) {
    throw std::runtime_error("--distances: found \"" + text +
                             "\", expected three or more growing distances over 0 m");
  }
  return distances;
}

// All but the centre.
vision::RingRules rules_of(const RingOptions& options,
                           const vision::CameraParameters& camera,
                           const vision::RadialTable& table) {
  vision::RingRules rules;
  rules.distances = growing_distances(options.distances);
  rules.sectors = camera.mask.sectors;
  rules.mirror_height = table.mirror_height;
  rules.inner_radius_px = std::max({camera.mask.inner_radius_px, options.inner_px, 20.0});
  return rules;
}

vision::Pixel centre_of(const RingOptions& options, const ImageFile& picture) {
  if (options.centre.empty()) return {0.5 * picture.width_px, 0.5 * picture.height_px};
  const std::vector<double> centre = read_numbers("--centre", options.centre, 2);
  if (std::min(centre[0], centre[1]) < 0.0 || centre[0] >= picture.width_px ||
      centre[1] >= picture.height_px) {
    throw std::runtime_error(
        fmt::format("--centre: found \"{}\", expected a place in {} of {}x{} pixels",
                    options.centre,
                    options.image,
                    picture.width_px,
                    picture.height_px));
  }
  return {centre[0], centre[1]};
}

ordered_json report(const std::string& image, const vision::RingCalibration& calibration) {
  ordered_json line;
  line["image"] = image;
  line["centre_u_px"] = calibration.centre.u;
  line["centre_v_px"] = calibration.centre.v;
  line["rings"] = ordered_json::array();
  double sum = 0.0;
  for (const vision::FoundRing& ring : calibration.rings) {
    line["rings"].push_back({{"radius_px", ring.mark.radius_px},
                             {"distance_m", ring.mark.distance},
                             {"sigma_px", ring.mark.sigma_px},
                             {"sigma_mean_px", ring.sigma_mean_px},
                             {"directions", ring.directions},
                             {"left_out_px", ring.left_out_px}});
    sum += ring.left_out_px * ring.left_out_px;
  }
  // The outermost ring cannot be left out: nothing lies beyond it.
  line["left_out_rms_px"] = std::sqrt(sum / static_cast<double>(calibration.rings.size() - 1));
  return line;
}

// Why the rings make no table, and what to do about it; one line.
std::string refusal_text(const vision::RingCalibration& calibration,
                         const std::vector<double>& distances) {
  const vision::RingDoubt& doubt = *calibration.doubt;
  if (doubt.trouble == vision::RingTrouble::kMissing) {
    return fmt::format(
        "no ring was found for {:g} m: the others agree without it; leave it out of --distances",
        distances[doubt.ring]);
  }
  const vision::FoundRing& ring = calibration.rings[doubt.ring];
  if (doubt.trouble == vision::RingTrouble::kNoRing) {
    const std::string remedy =
        doubt.ring == 0
            ? fmt::format("look from farther out (--inner {:.0f})", ring.mark.radius_px + 5.0)
            : "give its own distance as well, or cover what shines there";
    return fmt::format(
        "the ring at {:.1f} px is not that of {:g} m: without it the others agree; {}",
        ring.mark.radius_px,
        ring.mark.distance,
        remedy);
  }
  return fmt::format(
      "the ring at {:.1f} px, taken for {:g} m, lies {:.1f} px from where the others put it: check "
      "--distances, --inner and --centre against the picture",
      ring.mark.radius_px,
      ring.mark.distance,
      std::abs(ring.left_out_px));
}

// The base camera with its table's rows replaced. The centre stays: a calibration picture may be
// cut out of the frame.
vision::CameraParameters with_rings(vision::CameraParameters camera,
                                    const vision::RingCalibration& calibration) {
  auto& table = std::get<vision::RadialTable>(camera.mirror);
  // On the axis the camera sees itself: straight down. The radius is known only roughly there.
  table.rows = {{0.0, 0.0, 2.0}};
  for (const vision::FoundRing& ring : calibration.rings) table.rows.push_back(ring.mark);
  return camera;
}

int calibrate_rings(const RingOptions& options) {
  const auto camera = settings::load_camera(options.base);
  const auto* table = std::get_if<vision::RadialTable>(&camera.mirror);
  if (table == nullptr) {
    throw std::runtime_error(options.base + ": mirror: found profile, expected radial_table");
  }
  vision::RingRules rules = rules_of(options, camera, *table);
  const ImageFile picture = read_grey_picture(options.image);
  rules.centre = centre_of(options, picture);
  const auto calibration = vision::calibrate_rings(picture.view(), rules);
  if (!calibration) {
    std::cerr << "teamsight: " << options.image << ": fewer than three rings found\n";
    return kNo;
  }
  std::cout << report(options.image, *calibration).dump() << std::endl;
  if (calibration->doubt) {
    std::cerr << "teamsight: " << options.image << ": "
              << refusal_text(*calibration, rules.distances) << '\n';
    return kNo;
  }
  if (!options.out.empty()) {
    settings::save_camera(options.out,
                          with_rings(camera, *calibration),
                          "Radial table from rings: teamsight calibrate rings");
  }
  return 0;
}

}  // namespace

void add_calibrate_rings(CLI::App& calibrate, int& exit_code) {
  auto options = std::make_shared<RingOptions>();
  CLI::App* rings = calibrate.add_subcommand(
      "rings", "From rings at known distances. Exit 1: too few, or they contradict each other");
  rings->add_option("--base", options->base, "camera file to start from; needs a radial table")
      ->required();
  rings->add_option("--distances", options->distances, "of the rings in m, comma separated")
      ->required();
  rings->add_option("--centre", options->centre, "u_px,v_px in the picture; else its middle");
  rings->add_option("--inner", options->inner_px, "px; rings are looked for beyond this radius");
  rings->add_option("--out", options->out, "camera file to write");
  rings->add_option("image", options->image, "picture of the rings")->required();
  rings->callback([options, &exit_code] { exit_code = calibrate_rings(*options); });
}

}  // namespace teamsight::tools
