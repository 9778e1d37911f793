// vision/goal_detector.cpp: runs of one colour behind the carpet's end.
#include "vision/goal_detector.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/angle.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kGap = 4;         // samples of blur between carpet and goal
constexpr std::size_t kRun = 12;        // samples of white
constexpr std::size_t kDeep = 60;       // samples to a coloured back, over a goal's dark floor
constexpr std::size_t kLeastOfRun = 8;  // of those
constexpr double kNarrowest = 0.6;      // m; posts and people are narrower
constexpr double kWidest = 4.0;         // m; walls are wider
constexpr std::size_t kFewestFeet = 3;

/// What this sample speaks for. White stands right behind the carpet: farther back it is the hall.
ColourClass goal_colour(ColourClass colour, Surface surface, std::size_t behind_carpet) {
  if (colour == ColourClass::kBlue || colour == ColourClass::kYellow) return colour;
  const bool is_white = surface == Surface::kPaint && behind_carpet < kGap + kRun;
  return is_white ? ColourClass::kWhite : ColourClass::kNone;
}

}  // namespace

GoalDetector::GoalDetector(const ScanLines& lines, const CameraModel& model) {
  for (const ScanRange& range : lines.radial()) {
    azimuths_.push_back(model.azimuth(range.image_direction));
  }
  behind_.reserve(azimuths_.size());
  found_.reserve(azimuths_.size());
}

GoalDetector::Behind GoalDetector::behind(const RadialScan& scan,
                                          const ScanLines& lines,
                                          std::size_t i) const {
  const ScanRange& range = lines.radial()[i];
  const auto classes = scan.classes(range);
  const auto surfaces = scan.surfaces(range);
  const std::size_t end = scan.carpet_end(i);
  if (end == 0) return {};
  const std::size_t last = std::min(classes.size(), end + kDeep);
  std::array<std::size_t, 16> votes{};
  std::array<std::size_t, 16> first_of{};
  for (std::size_t k = end; k < last; ++k) {
    const ColourClass colour = goal_colour(classes[k], surfaces[k], k - end);
    if (colour == ColourClass::kNone) continue;
    const auto index = static_cast<std::size_t>(colour);
    if (votes[index]++ == 0) first_of[index] = k;
  }
  const auto most = std::ranges::max_element(votes);
  if (*most < kLeastOfRun) return {};
  const std::size_t first_coloured = first_of[static_cast<std::size_t>(most - votes.begin())];
  const ScanSample& foot = lines.samples(range)[end - 1];
  return {static_cast<ColourClass>(most - votes.begin()),
          static_cast<double>(std::hypot(foot.x, foot.y)),
          first_coloured - end <= kGap};
}

void GoalDetector::add(std::size_t first, std::size_t last) {
  double nearest = 0.0;
  std::size_t feet = 0;
  double sum = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    sum += behind_[i].distance;
    if (behind_[i].foot_seen) ++feet;
  }
  nearest = sum / static_cast<double>(last - first + 1);
  const double angle = std::abs(angle_difference(azimuths_[last], azimuths_[first]));
  const double width = 2.0 * nearest * std::sin(0.5 * std::min(angle, 3.0));
  if (width < kNarrowest || width > kWidest) return;
  SeenGoal goal;
  goal.colour = behind_[first].colour;
  const bool counter_clockwise = angle_difference(azimuths_[last], azimuths_[first]) > 0.0;
  goal.left = azimuths_[counter_clockwise ? last : first];
  goal.right = azimuths_[counter_clockwise ? first : last];
  goal.azimuth = wrap_angle(goal.right + 0.5 * angle);
  if (feet >= kFewestFeet) goal.distance = nearest;
  found_.push_back(goal);
}

std::span<const SeenGoal> GoalDetector::find(const RadialScan& scan, const ScanLines& lines) {
  behind_.clear();
  found_.clear();
  const std::size_t n = azimuths_.size();
  for (std::size_t i = 0; i < n; ++i) behind_.push_back(behind(scan, lines, i));
  std::size_t first = 0;
  for (std::size_t i = 1; i <= n; ++i) {
    const bool goes_on = i < n && behind_[i].colour == behind_[first].colour;
    if (goes_on) continue;
    if (behind_[first].colour != ColourClass::kNone) add(first, i - 1);
    first = i;
  }
  std::ranges::sort(found_, std::ranges::greater(), [](const SeenGoal& goal) {
    return std::abs(angle_difference(goal.left, goal.right));
  });
  return found_;
}

}  // namespace teamsight::vision
