// bench/locate_score/paper.cpp: spots, images, four methods.
#include "bench/locate_score/paper.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>

#include "bench/locate_rivals/markov_grid.hpp"
#include "bench/locate_rivals/triangulation.hpp"
#include "bench/locate_score/methods.hpp"
#include "bench/locate_score/rendered_view.hpp"

namespace teamsight::locate_score {

namespace {

constexpr int kHeadings = 6;
constexpr std::size_t kSpots = 15;
constexpr double kEdgeSigma = 0.0087;  // rad; half a degree: a pixel and what an edge is wide
constexpr double kEdgeRange = 8.0;     // m

struct Spot {
  std::string name;
  Point<Field> p_F;
};

// Corners of areas, crossings with the centre line, points between: what is marked on the floor.
std::vector<Spot> spots_of(const FieldModel& field) {
  const double x = 0.5 * field.length;
  const double y = 0.5 * field.width;
  std::vector<Spot> spots;
  for (const double along : {-0.66, -0.33, 0.0, 0.33, 0.66}) {
    for (const double across : {-0.6, 0.0, 0.6}) {
      spots.push_back({"spot " + std::to_string(spots.size() + 1),
                       {field.centre.x + along * x, field.centre.y + across * y}});
    }
  }
  spots.resize(kSpots);
  return spots;
}

template <class Work>
Answer timed(Work work) {
  const auto start = std::chrono::steady_clock::now();
  Answer answer = work();
  answer.time_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

// The camera file of a robot whose calibration left an error: what the picture is read with.
vision::CameraParameters misread(vision::CameraParameters camera,
                                 const CalibrationRemainder& remainder,
                                 std::mt19937& random) {
  std::normal_distribution<double> normal;
  if (auto* table = std::get_if<vision::RadialTable>(&camera.mirror)) {
    // A shift of the picture's centre by a tenth of a pixel moves the floor by millimetres.
    table->centre_u_px += 0.15 * normal(random);
    table->centre_v_px += 0.15 * normal(random);
    const double scale = 1.0 + remainder.scale * normal(random);
    for (vision::RingMark& row : table->rows) row.distance *= scale;
  }
  camera.forward += remainder.turn * normal(random);
  return camera;
}

Answer triangulate(const FieldModel& field,
                   const Look& look,
                   const CalibrationRemainder& remainder,
                   std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto edges = locate_rivals::upright_edges(field);
  const Eigen::Vector2d shift(remainder.shift * normal(random), remainder.shift * normal(random));
  const auto bearings =
      locate_rivals::look_at_edges(edges, look.truth, {kEdgeRange, kEdgeSigma, shift}, random);
  return timed([&] {
    locate_rivals::Triangulation filter(edges, kEdgeSigma);
    const Eigen::Vector3d sigma(0.2, 0.2, 0.1);
    filter.begin(look.prior, sigma.cwiseAbs2().asDiagonal());
    filter.see(bearings);
    return Answer{filter.estimate(), filter.cov(), 0.0};
  });
}

}  // namespace

std::vector<PaperImage> paper_images(const FieldModel& field, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> first(-std::numbers::pi, std::numbers::pi);
  std::vector<PaperImage> images;
  for (const Spot& spot : spots_of(field)) {
    const double start = first(random);
    for (int i = 0; i < kHeadings; ++i) {
      const double theta = start + 2.0 * std::numbers::pi * i / kHeadings;
      images.push_back({spot.name, {spot.p_F.x, spot.p_F.y, theta}});
    }
  }
  return images;
}

CaseResult run_paper(const CaseOptions& options, const CalibrationRemainder& remainder) {
  std::mt19937 random(options.seed + 90);
  std::normal_distribution<double> normal;
  const vision::CameraParameters file = misread(options.camera, remainder, random);
  RenderedView view(options.camera, file, options.field, options.pixel_noise_sigma);
  vision::Hough2001 hough(file, options.field);
  const locate_rivals::DistanceTable table(options.field);
  vision::LocalisationParameters parameters;
  parameters.tilt = view.head();
  Methods methods(options.field,
                  parameters,
                  {.global = false, .rivals = options.rivals, .hough = false},
                  options.seed);
  const auto symmetry =
      is_half_turn_symmetric(options.field) ? std::optional(options.field.centre) : std::nullopt;
  const Eigen::Vector2d none = Eigen::Vector2d::Zero();
  CaseResult result{"paper", options.field.name, {}};
  for (const PaperImage& image : paper_images(options.field, options.seed)) {
    view.draw(image.truth, {});
    const Answer found = timed([&] {
      const vision::Hough2001Result seen = hough.locate(view.image());
      Answer answer;
      if (seen.status != PostureStatus::kLost) answer.X_FR = seen.X_FR;
      return answer;
    });
    result.tallies["hough2001"].add(found, image.truth, none, symmetry);
    const auto seen = view.line_points();
    const std::vector<vision::LinePoint> points(seen.begin(), seen.end());
    const Pose<Field, Robot> prior(image.truth.x() + 0.1 * normal(random),
                                   image.truth.y() + 0.1 * normal(random),
                                   image.truth.theta() + 0.05 * normal(random));
    const Look look{image.truth, prior, points};
    result.tallies["triangulation"].add(
        triangulate(options.field, look, remainder, random), image.truth, none, std::nullopt);
    result.tallies["markov"].add(
        timed([&] {
          return Answer{locate_rivals::markov_localise(table, options.field, points), {}, 0.0};
        }),
        image.truth,
        none,
        symmetry);
    methods.ask(look, false);
  }
  for (const auto& [name, tally] : methods.tallies()) result.tallies[name] = tally;
  return result;
}

}  // namespace teamsight::locate_score
