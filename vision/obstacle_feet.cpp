// vision/obstacle_feet.cpp: joining neighbouring feet, and measuring the groups.
#include "vision/obstacle_feet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "geometry/angle.hpp"

namespace teamsight::vision {

namespace {

constexpr float kJump = 6.0F;        // samples between neighbours that still belong together
constexpr std::size_t kSkip = 3;     // lines from one to the next of a group
constexpr std::size_t kBeside = 10;  // lines beside a group that are asked where carpet ends
constexpr double kHidden = 1e4;      // samples; nothing is known of that side
constexpr float kFlat = 4.0F;        // samples
constexpr float kAlone = 4.0F;       // samples; so much farther counts a foot without neighbours
constexpr double kGap = 0.16;        // rad; a strut hides less
constexpr double kValley = 4.0;      // samples; two robots beside each other are that far apart
constexpr double kWide = 2.2;        // robot radii; a robot's foot is no wider
constexpr double kPair = 3.4;        // robot radii; that wide are two robots
constexpr std::size_t kFewestRays = 3;
constexpr float kNowhere = std::numeric_limits<float>::max();  // what does not stand

}  // namespace

Feet::Feet(std::size_t lines, double spacing) : spacing_(spacing) {
  feet_.reserve(lines);
  behind_.resize(lines);
}

bool Feet::joined(const Foot& a, const Foot& b) const {
  if (!a.stands || !b.stands) return false;
  const double gap = std::abs(angle_difference(a.azimuth, b.azimuth));
  if (gap > kGap) return false;
  // Wider apart (a strut), they may also differ more.
  const double step = gap / spacing_;
  const float jump =
      std::max(kJump, 2.0F * static_cast<float>(spacing_) * std::min(a.radius, b.radius));
  return std::abs(a.radius - b.radius) <= jump * static_cast<float>(std::min(2.0, std::sqrt(step)));
}

double Feet::angle_of(const FootGroup& group) const {
  return std::abs(angle_difference((*this)[group.last].azimuth, (*this)[group.first].azimuth)) +
         spacing_;
}

std::size_t Feet::standing_in(const FootGroup& group) const {
  std::size_t count = 0;
  for (std::size_t i = group.first; i <= group.last; ++i) {
    if ((*this)[i].stands) ++count;
  }
  return count;
}

// A single line that is nearer than both beside it is noise.
float Feet::sure_radius(const FootGroup& group, std::size_t i) const {
  const Foot& here = (*this)[i];
  if (!here.stands) return kNowhere;
  float beside = kNowhere;
  if (i > group.first && (*this)[i - 1].stands) beside = (*this)[i - 1].radius;
  if (i < group.last && (*this)[i + 1].stands) {
    beside = std::min(beside, (*this)[i + 1].radius);
  }
  return beside < kNowhere ? std::max(here.radius, beside) : here.radius + kAlone;
}

std::size_t Feet::nearest_in(const FootGroup& group) const {
  std::size_t nearest = group.first;
  float least = kNowhere;
  for (std::size_t i = group.first; i <= group.last; ++i) {
    const float radius = sure_radius(group, i);
    if (radius >= least) continue;
    least = radius;
    nearest = i;
  }
  return nearest;
}

double Feet::width_of(const FootGroup& group) const {
  return (*this)[nearest_in(group)].distance * std::min(angle_of(group), 3.0);
}

std::pair<double, double> Feet::prominence(const FootGroup& group) const {
  const auto beyond = [&](std::size_t edge, int direction) {
    const std::size_t n = feet_.size();
    std::array<float, kBeside> ends{};
    const float own = (*this)[nearest_in(group)].radius;
    std::size_t nearer = 0;
    for (std::size_t k = 0; k < kBeside; ++k) {
      const Foot& other = (*this)[direction > 0 ? edge + k + 2 : edge + n - k - 2];
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

// The middle of what is as near as the nearest line, but for the noise.
Eigen::Vector2d Feet::front_of(const FootGroup& group) const {
  const float reach = (*this)[nearest_in(group)].radius + kFlat;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (std::size_t i = group.first; i <= group.last; ++i) {
    const Foot& here = (*this)[i];
    if (!here.stands || here.radius > reach) continue;
    sum += Eigen::Vector2d(static_cast<double>(here.u), static_cast<double>(here.v));
    ++count;
  }
  return sum / std::max(1, count);
}

// As `nearest_in` of what begins at each foot, but from the last one back in one pass: only the
// first foot of a part lacks a neighbour.
void Feet::look_back(const FootGroup& group) {
  std::size_t nearest = group.last;
  float least = kNowhere;  // of the feet behind the part's first
  for (std::size_t i = group.last; i > group.first + 1; --i) {
    const bool is_first = sure_radius({i, group.last}, i) <= least;
    behind_[i - group.first] = (*this)[is_first ? i : nearest].radius;
    const float radius = sure_radius(group, i);
    if (radius > least) continue;
    least = radius;
    nearest = i;
  }
}

std::size_t Feet::valley_in(const FootGroup& group) {
  look_back(group);
  std::size_t valley = group.last;
  double deepest = kValley;
  std::size_t nearest = group.first;
  float least = kNowhere;  // of the feet before the last one on the left
  for (std::size_t i = group.first + 1; i < group.last; ++i) {
    const bool is_last = sure_radius({group.first, i - 1}, i - 1) < least;
    const float left = (*this)[is_last ? i - 1 : nearest].radius;
    const float right = behind_[i + 1 - group.first];
    const auto depth = static_cast<double>((*this)[i].radius - std::max(left, right));
    if (depth >= deepest) {
      deepest = depth;
      valley = i;
    }
    const float radius = sure_radius(group, i - 1);
    if (radius >= least) continue;
    least = radius;
    nearest = i - 1;
  }
  return valley;
}

void Feet::collect(double robot_radius, std::vector<FootGroup>& groups) {
  groups.clear();
  const std::size_t n = feet_.size();
  if (n < kFewestRays) return;
  // Begin where a group ends, so that none is cut in two by the seam at image right.
  std::size_t start = 0;
  while (start < n && joined((*this)[start + n - 1], (*this)[start])) ++start;
  if (start == n) return;
  for (std::size_t i = start; i < start + n;) {
    if (!(*this)[i].stands) {
      ++i;
      continue;
    }
    FootGroup group{i, i};
    // A line or two may miss what both its neighbours see.
    for (std::size_t k = i + 1; k < start + n && k - group.last <= kSkip; ++k) {
      if (joined((*this)[group.last], (*this)[k])) group.last = k;
    }
    split(group, robot_radius, groups);
    i = group.last + 1;
  }
}

void Feet::split(const FootGroup& group, double robot_radius, std::vector<FootGroup>& groups) {
  const bool is_wide = width_of(group) > kWide * robot_radius;
  std::size_t valley = is_wide ? valley_in(group) : group.last;
  // Two robots side by side may leave no gap.
  const bool is_pair = valley == group.last && width_of(group) > kPair * robot_radius;
  if (is_pair) valley = (group.first + group.last) / 2;
  if (valley == group.last) {
    groups.push_back(group);
    return;
  }
  split({group.first, valley}, robot_radius, groups);
  split({valley + 1, group.last}, robot_radius, groups);
}

}  // namespace teamsight::vision
