// vision/obstacle_detector.cpp: where the carpet ends, joined over neighbouring lines of sight.
#include "vision/obstacle_detector.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace teamsight::vision {

namespace {

constexpr double kRun = 0.25;            // m of floor that must be covered to be an obstacle
constexpr std::size_t kFewestInRun = 5;  // samples
constexpr double kFilled = 0.8;          // of a run
constexpr double kJump = 0.35;           // m between neighbours that still belong together
constexpr double kGap = 0.06;            // rad; a wider gap in azimuth (a strut) separates
constexpr double kNarrowest = 0.08;      // m
constexpr double kFootSigma = 1.5;       // px, of the foot
constexpr std::size_t kFewestRays = 3;

double distance_of(const ScanSample& sample) {
  return static_cast<double>(std::hypot(sample.x, sample.y));
}

}  // namespace

void ObstacleDetector::classify(const PixelReader& pixels,
                                const ColourClasses& colours,
                                std::span<const ScanSample> line) {
  stands_.clear();
  const std::size_t n = line.size();
  for (std::size_t i = 0; i < n; ++i) {
    // The mean of three: chroma is noisy, more so in the dark.
    int u = 0;
    int v = 0;
    int y = 0;
    for (const std::size_t k : {i > 0 ? i - 1 : i, i, i + 1 < n ? i + 1 : i}) {
      const Chroma chroma = pixels.chroma(line[k].nearest);
      u += chroma.u;
      v += chroma.v;
      y += pixels.luminance(line[k].nearest);
    }
    const auto mean = [](int sum) {
      return static_cast<std::uint8_t>(sum / 3);
    };
    const ColourClass colour = colours.of(mean(y), {mean(u), mean(v)});
    const bool is_ground = colour == ColourClass::kGreen || colour == ColourClass::kWhite ||
                           colour == ColourClass::kBall || colour == ColourClass::kNone;
    stands_.push_back(is_ground ? 0 : 1);
  }
}

ObstacleDetector::Foot ObstacleDetector::foot_of(std::span<const ScanSample> line) const {
  const std::size_t n = line.size();
  Foot foot;
  for (std::size_t i = 0; i < n; ++i) {
    if (stands_[i] == 0) continue;
    std::size_t filled = 0;
    std::size_t j = i;
    const double start = distance_of(line[i]);
    for (; j < n && (j - i < kFewestInRun || distance_of(line[j]) - start < kRun); ++j) {
      filled += stands_[j];
    }
    const auto length = static_cast<double>(j - i);
    if (j - i < kFewestInRun || static_cast<double>(filled) < kFilled * length) continue;
    foot.blocked = true;
    foot.distance = start;
    foot.depth = static_cast<double>(line[i].radial_footprint);
    foot.u = static_cast<double>(line[i].u);
    foot.v = static_cast<double>(line[i].v);
    return foot;
  }
  foot.distance = distance_of(line.back());
  return foot;
}

void ObstacleDetector::add(std::size_t first, std::size_t last) {
  const std::size_t count = last - first + 1;
  if (count < kFewestRays) return;
  const auto feet = std::span(feet_).subspan(first, count);
  const Foot& nearest = *std::ranges::min_element(feet, {}, &Foot::distance);
  const Foot& middle = feet[count / 2];
  const double step = std::abs(angle_difference(feet[1].azimuth, feet[0].azimuth));
  const double angle = std::abs(angle_difference(feet.back().azimuth, feet.front().azimuth)) + step;
  ObstacleCandidate candidate;
  ObstacleSighting& sighting = candidate.sighting;
  sighting.width = nearest.distance * std::min(angle, 3.0);
  if (sighting.width < kNarrowest || sighting.width > 6.0 * rules_.robot_radius) return;
  candidate.azimuth = middle.azimuth;
  candidate.distance = nearest.distance;
  candidate.u_px = nearest.u;
  candidate.v_px = nearest.v;
  const Eigen::Vector2d away{std::cos(middle.azimuth), std::sin(middle.azimuth)};
  const Eigen::Vector2d across{-away.y(), away.x()};
  sighting.p_RO = Point<Robot>::from(nearest.distance * away);
  const double sigma_away = std::max(0.03, kFootSigma * nearest.depth);
  const double sigma_across = std::max(0.03, 0.15 * sighting.width);
  sighting.cov_R = sigma_away * sigma_away * away * away.transpose() +
                   sigma_across * sigma_across * across * across.transpose();
  // Few lines of sight or an odd width make it less sure.
  const double off = (sighting.width - 2.0 * rules_.robot_radius) / (3.0 * rules_.robot_radius);
  sighting.confidence =
      0.9 * (1.0 - std::exp(-static_cast<double>(count) / 4.0)) * std::exp(-0.5 * off * off);
  found_.push_back(candidate);
}

void ObstacleDetector::group() {
  const std::size_t n = feet_.size();
  if (n < kFewestRays) return;
  const auto joined = [&](const Foot& a, const Foot& b) {
    return a.blocked && b.blocked && std::abs(a.distance - b.distance) < kJump &&
           std::abs(angle_difference(a.azimuth, b.azimuth)) < kGap;
  };
  // Begin where a group ends, so that none is cut in two by the seam at image right.
  std::size_t start = 0;
  while (start < n && joined(feet_[(start + n - 1) % n], feet_[start])) ++start;
  if (start == n) return;
  std::rotate(feet_.begin(), feet_.begin() + static_cast<std::ptrdiff_t>(start), feet_.end());
  std::size_t first = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool goes_on = i + 1 < n && joined(feet_[i], feet_[i + 1]);
    if (goes_on) continue;
    if (feet_[i].blocked) add(first, i);
    first = i + 1;
  }
}

std::span<const ObstacleCandidate> ObstacleDetector::find(const PixelReader& pixels,
                                                          const ColourClasses& colours,
                                                          const ScanLines& lines,
                                                          const CameraModel& model) {
  feet_.clear();
  free_.clear();
  found_.clear();
  for (const ScanRange& range : lines.radial()) {
    const auto line = lines.samples(range);
    classify(pixels, colours, line);
    Foot foot = foot_of(line);
    foot.azimuth = model.azimuth(range.image_direction);
    feet_.push_back(foot);
    free_.push_back({foot.azimuth, foot.distance, foot.blocked});
  }
  group();
  std::ranges::sort(found_, {}, &ObstacleCandidate::distance);
  if (found_.size() > kMaxObstacleSightings) found_.resize(kMaxObstacleSightings);
  return found_;
}

}  // namespace teamsight::vision
