// tools/shirt_score.cpp: rendering shirts, and counting.
#include "tools/shirt_score.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "sim/render/renderer.hpp"
#include "tools/rendered_field.hpp"
#include "vision/perception.hpp"

namespace teamsight::tools {

namespace {

using vision::ColourClass;

constexpr int kMoreRobots = 8;      // tried beside those of a random scene
constexpr double kApart = 0.52;     // m between robots' middles: they may touch
constexpr double kOwnRoom = 0.6;    // m around the robot that looks
constexpr double kSamePlace = 0.5;  // m from an obstacle's foot to its robot's middle
constexpr std::size_t kBins = 10;

constexpr std::array<ShirtPair, 6> kPairs{
    {{"cyan, magenta", {ColourClass::kCyan, ColourClass::kMagenta}, ColourClass::kMagenta},
     {"blue, red", {ColourClass::kBlue, ColourClass::kRed}, ColourClass::kRed},
     {"cyan, blue", {ColourClass::kCyan, ColourClass::kBlue}, ColourClass::kBlue},
     {"magenta, red", {ColourClass::kMagenta, ColourClass::kRed}, ColourClass::kRed},
     {"cyan, not said", {ColourClass::kCyan, ColourClass::kNone}, ColourClass::kRed},
     {"blue, magenta", {ColourClass::kBlue, ColourClass::kMagenta}, ColourClass::kMagenta}}};

sim::Paint paint_of(ColourClass colour) {
  switch (colour) {
    case ColourClass::kCyan:
      return {40, 190, 210};
    case ColourClass::kMagenta:
      return {220, 40, 180};
    case ColourClass::kBlue:
      return {30, 60, 200};
    default:
      return {200, 30, 30};
  }
}

std::uint8_t varied(std::uint8_t level, double sigma, sim::Random& random) {
  return static_cast<std::uint8_t>(
      std::clamp(static_cast<double>(level) + random.normal(sigma), 0.0, 255.0));
}

void add_robots(const FieldModel& field, sim::Random& random, sim::Scene& scene) {
  const Eigen::Vector2d own(scene.X_FR.x(), scene.X_FR.y());
  for (int i = 0; i < kMoreRobots; ++i) {
    sim::SceneRobot robot;
    robot.p_F = {field.centre.x + random.uniform(-0.5, 0.5) * field.length,
                 field.centre.y + random.uniform(-0.5, 0.5) * field.width};
    const bool is_free = (robot.p_F.vector() - own).norm() > kOwnRoom &&
                         std::ranges::all_of(scene.robots, [&](const sim::SceneRobot& other) {
                           return (other.p_F.vector() - robot.p_F.vector()).norm() > kApart;
                         });
    if (is_free) scene.robots.push_back(robot);
  }
}

// Gives each robot a shirt of either team. @return whether it is an own one
std::vector<bool> dress(const ShirtPair& pair,
                        double paint_sigma,
                        sim::Random& random,
                        sim::Scene& scene) {
  std::vector<bool> is_own;
  for (sim::SceneRobot& robot : scene.robots) {
    is_own.push_back(random.chance(0.5));
    const sim::Paint paint = paint_of(is_own.back() ? pair.shirts.own : pair.others);
    robot.shirt = {varied(paint.red, paint_sigma, random),
                   varied(paint.green, paint_sigma, random),
                   varied(paint.blue, paint_sigma, random)};
  }
  return is_own;
}

std::optional<std::size_t> robot_at(const Point<Field>& p_F, const sim::Scene& scene) {
  std::optional<std::size_t> best;
  double nearest = kSamePlace;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const double distance = (scene.robots[i].p_F.vector() - p_F.vector()).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    best = i;
  }
  return best;
}

void add_samples(const vision::FrameObservation& seen,
                 const sim::Scene& scene,
                 const std::vector<bool>& is_own,
                 std::vector<ShirtSample>& samples) {
  for (std::size_t i = 0; i < seen.obstacles.size(); ++i) {
    const vision::ObstaclePixels& pixels = seen.obstacle_pixels[i];
    if (pixels.kind != vision::ObstacleKind::kRobot) continue;
    const auto robot = robot_at(scene.X_FR * seen.obstacles[i].p_RO, scene);
    if (!robot) continue;
    samples.push_back({pixels.votes, seen.obstacles[i].p_RO.vector().norm(), is_own[*robot]});
  }
}

// Light goes through the sensor's curve, a square root.
double drawn_gain(double sigma, sim::Random& random) {
  return std::exp(2.0 * random.normal(sigma));
}

bool has_votes(const ShirtSample& sample) {
  return sample.votes != vision::ShirtVotes{};
}

}  // namespace

std::span<const ShirtPair> shirt_pairs() {
  return kPairs;
}

std::vector<ShirtSample> look_at_shirts(const ShirtField& where, const ShirtPair& pair) {
  vision::PerceptionParameters parameters;
  parameters.shirts = pair.shirts;
  vision::Perception perception(where.camera, where.field, parameters);
  sim::Random random(where.seed);
  std::vector<std::uint8_t> bytes;
  std::vector<ShirtSample> samples;
  for (std::size_t light = 0; light < where.lights; ++light) {
    sim::PictureParameters picture;
    picture.fineness = 2;
    picture.hall_seed = static_cast<std::uint32_t>(light + 1);
    picture.sensor.red_gain = drawn_gain(where.light_sigma, random);
    picture.sensor.green_gain = drawn_gain(where.light_sigma, random);
    picture.sensor.blue_gain = drawn_gain(where.light_sigma, random);
    sim::Renderer renderer(where.camera, where.field, picture);
    for (std::size_t frame = 0; frame < where.frames; ++frame) {
      sim::Scene scene = random_scene(where.field, random);
      add_robots(where.field, random, scene);
      const std::vector<bool> is_own = dress(pair, where.paint_sigma, random, scene);
      renderer.draw(scene, random, bytes);
      vision::MotionPrior prior;
      prior.X_FR = scene.X_FR;
      const vision::ImageView image{
          bytes, where.camera.width_px, where.camera.height_px, where.camera.format};
      add_samples(**perception.see(image, prior), scene, is_own, samples);
    }
  }
  return samples;
}

Calibration calibration_of(std::span<const ShirtSample> samples, const vision::VoteModel& model) {
  Calibration sum;
  sum.count = samples.size();
  for (const ShirtSample& sample : samples) {
    if (!has_votes(sample)) continue;
    ++sum.told;
    const double own = vision::teammate_likelihood(sample.votes, model);
    const double truth = sample.is_own ? own : 1.0 - own;
    sum.right += truth > 0.5 ? 1.0 : 0.0;
    sum.claimed += std::max(own, 1.0 - own);
    sum.log_loss -= std::log(std::max(truth, std::numeric_limits<double>::min()));
    sum.brier += (1.0 - truth) * (1.0 - truth);
  }
  const double told = static_cast<double>(std::max<std::size_t>(1, sum.told));
  sum.right /= told;
  sum.claimed /= told;
  sum.log_loss /= told;
  sum.brier /= told;
  return sum;
}

std::vector<ReliabilityBin> reliability_of(std::span<const ShirtSample> samples,
                                           const vision::VoteModel& model) {
  std::vector<ReliabilityBin> bins(kBins);
  for (const ShirtSample& sample : samples) {
    if (!has_votes(sample)) continue;
    const double own = vision::teammate_likelihood(sample.votes, model);
    ReliabilityBin& bin = bins[std::min(kBins - 1, static_cast<std::size_t>(own * kBins))];
    ++bin.count;
    bin.claimed += own;
    bin.own += sample.is_own ? 1.0 : 0.0;
  }
  std::erase_if(bins, [](const ReliabilityBin& bin) { return bin.count == 0; });
  for (ReliabilityBin& bin : bins) {
    bin.claimed /= static_cast<double>(bin.count);
    bin.own /= static_cast<double>(bin.count);
  }
  return bins;
}

vision::VoteModel fitted_votes(std::span<const ShirtSample> samples) {
  vision::VoteModel best;
  double least = std::numeric_limits<double>::max();
  double wrong = 0.002;
  for (int step = 0; step < 30; ++step) {
    wrong *= 1.15;
    for (int twentieth = 1; twentieth < 20; ++twentieth) {
      const vision::VoteModel model{wrong, 0.05 * twentieth};
      const double loss = calibration_of(samples, model).log_loss;
      if (loss >= least) continue;
      least = loss;
      best = model;
    }
  }
  return best;
}

}  // namespace teamsight::tools
