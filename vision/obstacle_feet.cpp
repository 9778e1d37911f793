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
constexpr double kGap = 0.16;        // rad; a strut hides less
constexpr double kValley = 4.0;      // samples; two robots beside each other are that far apart
constexpr double kWide = 2.2;        // robot radii; a robot's foot is no wider
constexpr double kPair = 3.4;        // robot radii; that wide are two robots
constexpr std::size_t kFewestRays = 3;

}  // namespace

Feet::Feet(std::size_t lines, double spacing) : spacing_(spacing) {
  feet_.reserve(lines);
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
std::size_t Feet::nearest_in(const FootGroup& group) const {
  std::size_t nearest = group.first;
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = group.first; i <= group.last; ++i) {
    if (!(*this)[i].stands) continue;
    float beside = std::numeric_limits<float>::max();
    for (const std::size_t k : {i - 1, i + 1}) {
      if (k < group.first || k > group.last || !(*this)[k].stands) continue;
      beside = std::min(beside, (*this)[k].radius);
    }
    const bool has_neighbour = beside < std::numeric_limits<float>::max();
    const float radius =
        has_neighbour ? std::max((*this)[i].radius, beside) : (*this)[i].radius + 4.0F;
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

std::size_t Feet::valley_in(const FootGroup& group) const {
  std::size_t valley = group.last;
  double deepest = kValley;
  for (std::size_t i = group.first + 1; i < group.last; ++i) {
    const float left = (*this)[nearest_in({group.first, i - 1})].radius;
    const float right = (*this)[nearest_in({i + 1, group.last})].radius;
    const auto depth = static_cast<double>((*this)[i].radius - std::max(left, right));
    if (depth < deepest) continue;
    deepest = depth;
    valley = i;
  }
  return valley;
}

void Feet::collect(double robot_radius, std::vector<FootGroup>& groups) const {
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

void Feet::split(const FootGroup& group,
                 double robot_radius,
                 std::vector<FootGroup>& groups) const {
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
