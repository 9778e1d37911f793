// vision/obstacle_detector.cpp: where the carpet ends, joined over neighbouring lines of sight.
#include "vision/obstacle_detector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "geometry/angle.hpp"

namespace teamsight::vision {

namespace {

constexpr double kRun = 0.25;            // m of floor that must be covered to be an obstacle
constexpr std::size_t kFewestInRun = 6;  // samples
constexpr double kTall = 0.35;  // of its distance: so much floor behind it a low thing hides
constexpr std::size_t kMostInRun = 40;   // samples; near the robot a decimetre has many
constexpr double kFilled = 0.65;         // of a run
constexpr std::size_t kContact = 8;      // samples of blur between carpet and what stands on it
constexpr std::size_t kReach = 16;       // samples behind the carpet's end
constexpr float kJump = 6.0F;            // px between neighbours that still belong together
constexpr std::size_t kSkip = 3;         // lines from one to the next of a group
constexpr std::size_t kBeside = 10;      // lines beside a group that are asked where carpet ends
constexpr double kProminent = 14.0;      // px
constexpr double kProminentShirt = 7.0;  // px
constexpr double kHidden = 1e4;          // px; nothing is known of that side
constexpr double kWellInside = 20.0;     // px
constexpr float kFlat = 4.0F;            // px
constexpr double kGap = 0.16;            // rad; a strut hides less
constexpr double kNarrowest = 0.07;      // m
constexpr double kLegWidth = 0.24;       // m; narrower things are legs
constexpr double kStride = 0.6;          // m between the legs of one person
constexpr double kValley = 4.0;          // px; two robots beside each other are that far apart
constexpr double kFootSigma = 1.5;       // px, of the foot
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
  spacing_ = std::numbers::pi;
  for (std::size_t i = 1; i < n; ++i) {
    spacing_ = std::min(spacing_, std::abs(angle_difference(azimuths_[i], azimuths_[i - 1])));
  }
  feet_.reserve(n);
  free_.reserve(n);
  groups_.reserve(n + 1);
  found_.reserve(n + 1);
}

ObstacleDetector::Foot ObstacleDetector::foot_of(const RadialScan& scan,
                                                 const ScanLines& lines,
                                                 std::size_t index) const {
  const ScanRange& range = lines.radial()[index];
  const auto line = lines.samples(range);
  const std::size_t carpet_end = scan.carpet_end(index);
  const auto surfaces = scan.surfaces(range);
  const auto place = [&](std::size_t i) {
    return static_cast<float>(std::hypot(static_cast<double>(line[i].u) - centre_.u,
                                         static_cast<double>(line[i].v) - centre_.v));
  };
  Foot foot;
  std::size_t last_floor = 0;  // the line begins on the own body's edge
  const std::size_t last = std::min(carpet_end + kReach, line.size());
  std::size_t end = carpet_end > 0 ? carpet_end - 1 : 0;
  foot.carpet_end = place(end);
  for (std::size_t i = 0; i < last; ++i) {
    if (is_floor(surfaces[i])) last_floor = i;
    const std::size_t run = runs_[range.first + i];
    if (run < kFewestInRun) break;
    if (!is_standing(surfaces[i]) || share(surfaces, i, i + run, is_standing) < kFilled) continue;
    foot.stands = i - last_floor <= kContact;
    if (foot.stands) end = i;
    break;
  }
  foot.distance = distance_of(line[end]);
  foot.depth = static_cast<double>(line[end].radial_footprint);
  foot.u = line[end].u;
  foot.v = line[end].v;
  foot.radius = place(end);
  return foot;
}

bool ObstacleDetector::joined(const Foot& a, const Foot& b) const {
  if (!a.stands || !b.stands) return false;
  const double gap = std::abs(angle_difference(a.azimuth, b.azimuth));
  if (gap > kGap) return false;
  // Wider apart (a strut), they may also differ more.
  const double step = gap / spacing_;
  const float jump =
      std::max(kJump, 2.0F * static_cast<float>(spacing_) * std::min(a.radius, b.radius));
  return std::abs(a.radius - b.radius) <= jump * static_cast<float>(std::min(2.0, std::sqrt(step)));
}

double ObstacleDetector::angle_of(const Group& group) const {
  return std::abs(angle_difference(foot(group.last).azimuth, foot(group.first).azimuth)) + spacing_;
}

std::size_t ObstacleDetector::standing_in(const Group& group) const {
  std::size_t count = 0;
  for (std::size_t i = group.first; i <= group.last; ++i) {
    if (foot(i).stands) ++count;
  }
  return count;
}

// A single line that is nearer than both beside it is noise.
std::size_t ObstacleDetector::nearest_in(const Group& group) const {
  std::size_t nearest = group.first;
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = group.first; i <= group.last; ++i) {
    if (!foot(i).stands) continue;
    float beside = std::numeric_limits<float>::max();
    for (const std::size_t k : {i - 1, i + 1}) {
      if (k < group.first || k > group.last || !foot(k).stands) continue;
      beside = std::min(beside, foot(k).radius);
    }
    const bool has_neighbour = beside < std::numeric_limits<float>::max();
    const float radius = has_neighbour ? std::max(foot(i).radius, beside) : foot(i).radius + 4.0F;
    if (radius >= least) continue;
    least = radius;
    nearest = i;
  }
  return nearest;
}

double ObstacleDetector::width_of(const Group& group) const {
  return foot(nearest_in(group)).distance * std::min(angle_of(group), 3.0);
}

std::pair<double, double> ObstacleDetector::prominence(const Group& group) const {
  const auto beyond = [&](std::size_t edge, int direction) {
    const std::size_t n = feet_.size();
    std::array<float, kBeside> ends{};
    const float own = foot(nearest_in(group)).radius;
    std::size_t nearer = 0;
    for (std::size_t k = 0; k < kBeside; ++k) {
      const Foot& other = foot(direction > 0 ? edge + k + 2 : edge + n - k - 2);
      ends[k] = other.carpet_end;
      if (other.stands && other.radius < own) ++nearer;
    }
    // Something nearer hides what is on that side.
    if (2 * nearer >= kBeside) return kHidden;
    // Not the very farthest: a border of chairs and boxes has teeth.
    std::nth_element(ends.begin(), ends.begin() + 2, ends.end(), std::greater<>());
    return static_cast<double>(ends[2] - own);
  };
  const double left = beyond(group.first, -1);
  const double right = beyond(group.last, 1);
  return std::minmax(left, right);
}

void ObstacleDetector::collect_groups() {
  groups_.clear();
  const std::size_t n = feet_.size();
  if (n < kFewestRays) return;
  // Begin where a group ends, so that none is cut in two by the seam at image right.
  std::size_t start = 0;
  while (start < n && joined(foot(start + n - 1), foot(start))) ++start;
  if (start == n) return;
  for (std::size_t i = start; i < start + n;) {
    if (!foot(i).stands) {
      ++i;
      continue;
    }
    Group group{i, i};
    // A line or two may miss what both its neighbours see.
    for (std::size_t k = i + 1; k < start + n && k - group.last <= kSkip; ++k) {
      if (joined(foot(group.last), foot(k))) group.last = k;
    }
    split(group);
    i = group.last + 1;
  }
}

// The middle of what is as near as the nearest line, but for the noise.
Eigen::Vector2d ObstacleDetector::front_of(const Group& group) const {
  const float reach = foot(nearest_in(group)).radius + kFlat;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (std::size_t i = group.first; i <= group.last; ++i) {
    const Foot& here = foot(i);
    if (!here.stands || here.radius > reach) continue;
    sum += Eigen::Vector2d(static_cast<double>(here.u), static_cast<double>(here.v));
    ++count;
  }
  return sum / std::max(1, count);
}

std::size_t ObstacleDetector::valley_in(const Group& group) const {
  std::size_t valley = group.last;
  double deepest = kValley;
  for (std::size_t i = group.first + 1; i < group.last; ++i) {
    const float left = foot(nearest_in({group.first, i - 1})).radius;
    const float right = foot(nearest_in({i + 1, group.last})).radius;
    const auto depth = static_cast<double>(foot(i).radius - std::max(left, right));
    if (depth < deepest) continue;
    deepest = depth;
    valley = i;
  }
  return valley;
}

void ObstacleDetector::split(const Group& group) {
  const bool is_wide = width_of(group) > 2.2 * rules_.robot_radius;
  const std::size_t valley = is_wide ? valley_in(group) : group.last;
  if (valley == group.last) {
    groups_.push_back(group);
    return;
  }
  split({group.first, valley});
  split({valley + 1, group.last});
}

ColourClass ObstacleDetector::shirt_of(const Group& group,
                                       const RadialScan& scan,
                                       const ScanLines& lines) const {
  std::array<std::size_t, 16> votes{};
  for (std::size_t i = group.first; i <= group.last; ++i) {
    const Foot& here = foot(i);
    const ScanRange& range = lines.radial()[here.index];
    const auto line = lines.samples(range);
    const auto classes = scan.classes(range);
    std::size_t k = 0;
    while (k < line.size() && (line[k].u != here.u || line[k].v != here.v)) ++k;
    const std::size_t end = std::min(line.size(), k + 60);
    for (; k < end; ++k) ++votes[static_cast<std::size_t>(classes[k])];
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

void ObstacleDetector::add(const Group& group, const RadialScan& scan, const ScanLines& lines) {
  const std::size_t count = group.last - group.first + 1;
  const std::size_t standing = standing_in(group);
  if (standing < kFewestRays || 5 * standing < 3 * count) return;
  const double width = width_of(group);
  const Foot& nearest = foot(nearest_in(group));
  const bool touches = nearest.distance < 0.6;  // the own body hides its sides
  if (width < kNarrowest || (width > 5.0 * rules_.robot_radius && !touches)) return;
  const auto [smaller, larger] = prominence(group);
  const ColourClass shirt = shirt_of(group, scan, lines);
  if (smaller < (shirt == ColourClass::kNone ? kProminent : kProminentShirt)) return;
  ObstacleCandidate candidate;
  ObstacleSighting& sighting = candidate.sighting;
  sighting.width = width;
  candidate.pixels.kind = width < kLegWidth ? ObstacleKind::kLegs : ObstacleKind::kRobot;
  candidate.pixels.shirt = shirt;
  candidate.azimuth =
      wrap_angle(foot(group.first).azimuth +
                 0.5 * angle_difference(foot(group.last).azimuth, foot(group.first).azimuth));
  candidate.distance = nearest.distance;
  const Eigen::Vector2d front = front_of(group);
  candidate.pixels.u_px = front.x();
  candidate.pixels.v_px = front.y();
  candidate.pixels.on_carpet = smaller >= kWellInside;
  const Eigen::Vector2d away{std::cos(candidate.azimuth), std::sin(candidate.azimuth)};
  const Eigen::Vector2d across{-away.y(), away.x()};
  sighting.p_RO = Point<Robot>::from(nearest.distance * away);
  const double sigma_away = std::max(0.03, kFootSigma * nearest.depth);
  const double sigma_across = std::max(0.03, 0.15 * sighting.width);
  sighting.cov_R = sigma_away * sigma_away * away * away.transpose() +
                   sigma_across * sigma_across * across * across.transpose();
  const double clear = 1.0 - std::exp(-std::max(0.0, smaller) / 6.0);
  const double enough = 1.0 - std::exp(-static_cast<double>(count) / 3.0);
  const double fit = candidate.pixels.kind == ObstacleKind::kRobot ? 1.0 : 0.5;
  sighting.confidence = 0.95 * enough * fit * (0.5 + 0.5 * clear);
  found_.push_back(candidate);
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
                                                          const ScanLines& lines) {
  feet_.clear();
  free_.clear();
  found_.clear();
  const auto radial = lines.radial();
  for (std::size_t i = 0; i < radial.size(); ++i) {
    Foot foot = foot_of(scan, lines, i);
    foot.azimuth = azimuths_[i];
    foot.index = static_cast<std::uint16_t>(i);
    feet_.push_back(foot);
    free_.push_back({foot.azimuth, foot.distance, foot.stands});
  }
  collect_groups();
  for (const Group& group : groups_) add(group, scan, lines);
  join_legs();
  if (found_.size() > kMaxObstacleSightings) found_.resize(kMaxObstacleSightings);
  return found_;
}

}  // namespace teamsight::vision
