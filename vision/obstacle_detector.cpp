// vision/obstacle_detector.cpp: where the carpet ends, joined over neighbouring lines of sight.
#include "vision/obstacle_detector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "geometry/angle.hpp"
#include "vision/lanes.hpp"

namespace teamsight::vision {

namespace {

constexpr double kRun = 0.25;            // m of floor that must be covered to be an obstacle
constexpr std::size_t kFewestInRun = 6;  // samples
constexpr double kTall = 0.35;  // of its distance: so much floor behind it a low thing hides
constexpr std::size_t kMostInRun = 40;   // samples; near the robot a decimetre has many
constexpr double kFilled = 0.65;         // of a run
constexpr std::size_t kContact = 8;      // samples of blur between carpet and what stands on it
constexpr std::size_t kReach = 16;       // samples behind the carpet's end
constexpr double kWellInside = 20.0;     // samples
constexpr std::size_t kMostVeiled = 24;  // samples of a base that looks like dark carpet
constexpr float kFewestCarpet = 8.0F;    // samples that tell how bright the carpet is there
constexpr float kVeiled = 0.75F;         // of the carpet's luminance
constexpr double kNarrowest = 0.07;      // m
constexpr double kNarrowestLegs = 0.05;  // m, of the parts of legs that the lines show
constexpr double kLegWidth = 0.24;       // m; narrower things are legs
constexpr double kLegConfidence = 0.4;   // of what is narrow and well inside the carpet
constexpr double kStride = 0.6;          // m between the legs of one person
constexpr double kFootSigma = 1.5;       // samples, of the foot
constexpr std::size_t kAboveFoot = 60;   // samples that may show a shirt
constexpr std::size_t kFewestRays = 3;

bool is_standing(Surface surface) {
  return surface == Surface::kDark || surface == Surface::kShirt;
}

bool is_floor(Surface surface) {
  return surface == Surface::kCarpet || surface == Surface::kPaint || surface == Surface::kBall;
}

double distance_of(const ScanSample& sample) {
  return static_cast<double>(std::hypot(sample.x, sample.y));
}

/// How many samples from `i` on decide whether something stands there.
std::uint8_t run_from(std::span<const ScanSample> line, std::size_t i) {
  static_assert(kMostInRun <= std::numeric_limits<std::uint8_t>::max());
  const double start = distance_of(line[i]);
  std::size_t j = i;
  while (j < line.size() && j - i < kMostInRun &&
         (j - i < kFewestInRun || distance_of(line[j]) - start < std::max(kRun, kTall * start))) {
    ++j;
  }
  return static_cast<std::uint8_t>(j - i);
}

template <class Claim>
double share(std::span<const Surface> surfaces, std::size_t first, std::size_t last, Claim claim) {
  const auto count = std::count_if(surfaces.begin() + static_cast<std::ptrdiff_t>(first),
                                   surfaces.begin() + static_cast<std::ptrdiff_t>(last),
                                   claim);
  return static_cast<double>(count) / static_cast<double>(last - first);
}

// The mirror veils a black base until it looks like carpet in the dark: such samples right before
// sample `i`, where something stands, are its foot.
std::size_t dark_start(const RadialScan& scan, const ScanRange& range, std::size_t i) {
  const auto luminance = scan.luminance(range);
  const auto surfaces = scan.surfaces(range);
  const std::size_t first = i - std::min(i, kMostVeiled);
  float sum = 0.0F;
  float count = 0.0F;
  for (std::size_t k = first - std::min(first, kMostVeiled); k < first; ++k) {
    if (surfaces[k] != Surface::kCarpet) continue;
    sum += static_cast<float>(luminance[k]);
    count += 1.0F;
  }
  if (count < kFewestCarpet) return i;
  while (i > first && static_cast<float>(luminance[i - 1]) * count < kVeiled * sum) --i;
  return i;
}

}  // namespace

ObstacleDetector::ObstacleDetector(const ObstacleRules& rules,
                                   const ScanLines& lines,
                                   const CameraModel& model)
    : rules_(rules),
      centre_(model.centre()) {
  for (const ScanRange& range : lines.radial()) {
    azimuths_.push_back(model.azimuth(range.image_direction));
    const auto line = lines.samples(range);
    runs_.resize(std::max(runs_.size(), range.first + range.count));
    for (std::size_t i = 0; i < range.count; ++i) runs_[range.first + i] = run_from(line, i);
  }
  const std::size_t n = azimuths_.size();
  double spacing = std::numbers::pi;
  for (std::size_t i = 1; i < n; ++i) {
    spacing = std::min(spacing, std::abs(angle_difference(azimuths_[i], azimuths_[i - 1])));
  }
  feet_ = Feet(n, spacing);
  free_.reserve(n);
  groups_.reserve(n + 1);
  found_.reserve(n + 1);
  parts_.reserve(n + 1);
}

Foot ObstacleDetector::foot_of(const RadialScan& scan,
                               const ScanLines& lines,
                               std::size_t index) const {
  const ScanRange& range = lines.radial()[index];
  const auto line = lines.samples(range);
  const std::size_t carpet_end = scan.carpet_end(index);
  const auto surfaces = scan.surfaces(range);
  const auto step = static_cast<double>(range.pitch);
  const auto place = [&](std::size_t i) {
    const double radius = std::hypot(static_cast<double>(line[i].u) - centre_.u,
                                     static_cast<double>(line[i].v) - centre_.v);
    return static_cast<float>(radius / step);
  };
  Foot foot;
  std::size_t last_floor = 0;  // the line begins on the own body's edge
  // So near to the line's end too few samples are left to decide what stands there.
  const std::size_t last =
      std::min(carpet_end + kReach, line.size() - std::min(kFewestInRun - 1, line.size()));
  std::size_t end = carpet_end > 0 ? carpet_end - 1 : 0;
  foot.carpet_end = place(end);
  for (std::size_t i = 0; i < last; ++i) {
    const std::size_t carpet = leading_eights(surfaces.subspan(i), Surface::kCarpet);
    i += carpet;
    if (i >= last) break;
    if (carpet > 0) last_floor = i - 1;
    if (is_floor(surfaces[i])) last_floor = i;
    const std::size_t run = runs_[range.first + i];
    if (!is_standing(surfaces[i]) || share(surfaces, i, i + run, is_standing) < kFilled) continue;
    foot.stands = i - last_floor <= kContact;
    if (foot.stands) end = dark_start(scan, range, i);
    break;
  }
  foot.distance = distance_of(line[end]);
  foot.depth = step * static_cast<double>(line[end].radial_footprint);
  foot.u = line[end].u;
  foot.v = line[end].v;
  foot.radius = place(end);
  foot.sample = static_cast<std::uint16_t>(end);
  return foot;
}

ColourClass ObstacleDetector::shirt_of(const FootGroup& group,
                                       const RadialScan& scan,
                                       const ScanLines& lines) const {
  std::array<std::size_t, 16> votes{};
  for (std::size_t i = group.first; i <= group.last; ++i) {
    const Foot& here = feet_[i];
    const ScanRange& range = lines.radial()[here.index];
    const auto classes = scan.classes(range);
    const std::size_t end = std::min(classes.size(), here.sample + kAboveFoot);
    for (std::size_t k = here.sample; k < end; ++k) ++votes[static_cast<std::size_t>(classes[k])];
  }
  ColourClass best = ColourClass::kNone;
  std::size_t most = 3 * (group.last - group.first + 1);
  for (const ColourClass colour :
       {ColourClass::kRed, ColourClass::kBlue, ColourClass::kMagenta, ColourClass::kCyan}) {
    const std::size_t count = votes[static_cast<std::size_t>(colour)];
    if (count <= most) continue;
    most = count;
    best = colour;
  }
  return best;
}

ObstacleCandidate ObstacleDetector::candidate_of(const FootGroup& group,
                                                 double width,
                                                 const CarpetHull& hull) const {
  const Foot& nearest = feet_[feet_.nearest_in(group)];
  ObstacleCandidate candidate;
  ObstacleSighting& sighting = candidate.sighting;
  sighting.width = width;
  candidate.azimuth =
      wrap_angle(feet_[group.first].azimuth +
                 0.5 * angle_difference(feet_[group.last].azimuth, feet_[group.first].azimuth));
  candidate.distance = nearest.distance;
  const Eigen::Vector2d front = feet_.front_of(group);
  candidate.pixels.u_px = front.x();
  candidate.pixels.v_px = front.y();
  candidate.pixels.on_carpet = nearest.sample < hull.end(nearest.index);
  const Eigen::Vector2d away{std::cos(candidate.azimuth), std::sin(candidate.azimuth)};
  const Eigen::Vector2d across{-away.y(), away.x()};
  sighting.p_RO = Point<Robot>::from(nearest.distance * away);
  const double sigma_away = std::max(0.03, kFootSigma * nearest.depth);
  const double sigma_across = std::max(0.03, 0.15 * sighting.width);
  sighting.cov_R = sigma_away * sigma_away * away * away.transpose() +
                   sigma_across * sigma_across * across * across.transpose();
  candidate.pixels.kind = ObstacleKind::kLegs;
  sighting.confidence = kLegConfidence;
  return candidate;
}

void ObstacleDetector::add(const FootGroup& group, const TraitSource& source) {
  const std::size_t count = group.last - group.first + 1;
  const std::size_t standing = feet_.standing_in(group);
  if (5 * standing < 3 * count) return;
  const double width = feet_.width_of(group);
  const double smaller = feet_.prominence(group).first;
  if (standing < kFewestRays || width < kNarrowest) {
    if (smaller >= kWellInside) {
      parts_.push_back({candidate_of(group, width, source.hull), standing});
    }
    return;
  }
  const Foot& nearest = feet_[feet_.nearest_in(group)];
  const bool touches = nearest.distance < 0.6;  // the own body hides its sides
  if (width > 5.0 * rules_.robot_radius && !touches) return;
  const ObstacleTraits traits = traits_of(group, source);
  const double likely = probability(rules_.model, traits);
  const bool is_robot = likely >= rules_.model.least;
  if (!is_robot && (width > kLegWidth || smaller < kWellInside)) return;
  ObstacleCandidate candidate = candidate_of(group, width, source.hull);
  candidate.pixels.traits = traits;
  candidate.pixels.shirt = shirt_of(group, source.scan, source.lines);
  // People wear what they like.
  if (is_robot) {
    candidate.pixels.kind = ObstacleKind::kRobot;
    candidate.sighting.confidence = likely;
    candidate.pixels.votes = shirt_votes(group, source, rules_.shirts);
    candidate.sighting.teammate_likelihood = teammate_likelihood(candidate.pixels.votes);
  }
  found_.push_back(candidate);
}

// Shoe, ankle and shin of a leg end on lines of sight at places too far apart to be one foot. So
// small a thing is noise by itself; with others within a stride it is legs, at the nearest.
void ObstacleDetector::join_parts() {
  const auto distance_between = [](const ObstacleCandidate& a, const ObstacleCandidate& b) {
    return (a.sighting.p_RO.vector() - b.sighting.p_RO.vector()).norm();
  };
  std::ranges::sort(parts_, {}, [](const LegPart& part) { return part.candidate.distance; });
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    ObstacleCandidate legs = parts_[i].candidate;
    std::size_t lines = 0;
    double width = 0.0;
    for (std::size_t j = i; j < parts_.size(); ++j) {
      if (distance_between(parts_[j].candidate, legs) > kStride) continue;
      lines += parts_[j].lines;
      width += parts_[j].candidate.sighting.width;
    }
    if (lines < kFewestRays || width < kNarrowestLegs) continue;
    // What belongs to a thing that is told already, legs found just now among them.
    const bool is_told = std::ranges::any_of(found_, [&](const ObstacleCandidate& other) {
      return distance_between(other, legs) < kStride;
    });
    if (is_told) continue;
    legs.sighting.width = width;
    found_.push_back(legs);
  }
}

// The legs of one person are one obstacle, at the nearer foot.
void ObstacleDetector::join_legs() {
  std::ranges::sort(found_, {}, &ObstacleCandidate::distance);
  for (std::size_t i = 0; i < found_.size(); ++i) {
    if (found_[i].pixels.kind != ObstacleKind::kLegs) continue;
    for (std::size_t j = i + 1; j < found_.size(); ++j) {
      const Eigen::Vector2d apart =
          found_[j].sighting.p_RO.vector() - found_[i].sighting.p_RO.vector();
      if (found_[j].pixels.kind != ObstacleKind::kLegs || apart.norm() > kStride) continue;
      found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(j));
      found_[i].sighting.width = std::max(found_[i].sighting.width, apart.norm());
      break;
    }
  }
}

std::span<const ObstacleCandidate> ObstacleDetector::find(const RadialScan& scan,
                                                          const ScanLines& lines,
                                                          const CarpetHull& hull) {
  feet_.clear();
  free_.clear();
  found_.clear();
  parts_.clear();
  const auto radial = lines.radial();
  for (std::size_t i = 0; i < radial.size(); ++i) {
    Foot foot = foot_of(scan, lines, i);
    foot.azimuth = azimuths_[i];
    foot.index = static_cast<std::uint16_t>(i);
    feet_.add(foot);
    free_.push_back({foot.azimuth, foot.distance, foot.stands});
  }
  feet_.collect(rules_.robot_radius, groups_);
  const TraitSource source{feet_, scan, lines, hull, rules_.robot_radius};
  for (const FootGroup& group : groups_) add(group, source);
  join_parts();
  join_legs();
  return found_;
}

}  // namespace teamsight::vision
