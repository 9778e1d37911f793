// vision/carpet_hull.cpp: the monotone chain over where the radial lines leave the carpet.
#include "vision/carpet_hull.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <tuple>

namespace teamsight::vision {

namespace {

constexpr std::size_t kWindow = 5;      // lines that must agree on how far the carpet reaches
constexpr std::size_t kFewestEnds = 3;  // of a hull

// Positive where `c` lies to the left of the way from `a` to `b`.
float turn(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c) {
  const Eigen::Vector2f way = b - a;
  const Eigen::Vector2f next = c - a;
  return way.x() * next.y() - way.y() * next.x();
}

// How far a place lies to the left of each edge.
FourFloats left_of(const FourEdges& edges, const ScanSample& sample) {
  return edges.x * sample.x + edges.y * sample.y + edges.z;
}

// The same of one of them.
float left_of(const FourEdges& edges, std::size_t lane, const ScanSample& sample) {
  return edges.x[lane] * sample.x + edges.y[lane] * sample.y + edges.z[lane];
}

/// One edge.
struct Edge {
  const FourEdges* four{nullptr};
  std::size_t lane{0};
};

}  // namespace

CarpetHull::CarpetHull(const ScanLines& lines) {
  const std::size_t n = lines.radial().size();
  reach_.reserve(n);
  points_.reserve(n);
  hull_.reserve(2 * n + 2);
  edges_.reserve((2 * n + 2) / kLanes + 1);
  ends_.reserve(n);
}

// A line may end in a green thing far away: it reaches no farther than the lines beside it.
void CarpetHull::collect(const RadialScan& scan, const ScanLines& lines) {
  const auto radial = lines.radial();
  const std::size_t n = radial.size();
  reach_.clear();
  points_.clear();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t end = scan.carpet_end(i);
    const auto line = lines.samples(radial[i]);
    reach_.push_back(end == 0 ? 0.0F : std::hypot(line[end - 1].x, line[end - 1].y));
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::array<float, kWindow> beside{};
    for (std::size_t k = 0; k < kWindow; ++k) beside[k] = reach_[(i + n + k - kWindow / 2) % n];
    std::ranges::nth_element(beside, beside.begin() + kWindow / 2);
    const float reach = std::min(reach_[i], beside[kWindow / 2]);
    if (reach <= 0.0F) continue;
    const ScanSample& last = lines.samples(radial[i])[scan.carpet_end(i) - 1];
    points_.push_back(Eigen::Vector2f(last.x, last.y) * (reach / reach_[i]));
  }
}

void CarpetHull::wrap() {
  hull_.clear();
  if (points_.size() < kFewestEnds) return;
  std::ranges::sort(points_, [](const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
    return std::make_tuple(a.x(), a.y()) < std::make_tuple(b.x(), b.y());
  });
  const auto add = [&](const Eigen::Vector2f& point, std::size_t start) {
    while (hull_.size() >= start + 2 &&
           turn(hull_[hull_.size() - 2], hull_.back(), point) <= 0.0F) {
      hull_.pop_back();
    }
    hull_.push_back(point);
  };
  for (const Eigen::Vector2f& point : points_) add(point, 0);
  hull_.pop_back();
  const std::size_t upper = hull_.size();
  for (auto point = points_.rbegin(); point != points_.rend(); ++point) add(*point, upper);
  hull_.pop_back();
}

// A place is inside if it lies to the left of all.
void CarpetHull::find_edges() {
  edges_.clear();
  for (std::size_t k = 0; k < hull_.size(); ++k) {
    const Eigen::Vector2f& start = hull_[k];
    const Eigen::Vector2f way = hull_[(k + 1) % hull_.size()] - start;
    const std::size_t lane = k % kLanes;
    // Lanes without an edge have everything to their left.
    if (lane == 0) edges_.push_back({FourFloats{}, FourFloats{}, FourFloats{} + 1.0F});
    FourEdges& edges = edges_.back();
    edges.x[lane] = -way.y();
    edges.y[lane] = way.x();
    edges.z[lane] = way.y() * start.x() - way.x() * start.y();
  }
}

std::size_t CarpetHull::inside_count(std::span<const ScanSample> line) const {
  if (hull_.size() < kFewestEnds) return 0;
  Edge crossed;
  float least = 1.0F;  // share of the way to the line's end
  for (const FourEdges& edges : edges_) {
    const FourFloats first = left_of(edges, line.front());
    if (bits_of(first < 0.0F) != 0) return 0;
    const FourFloats last = left_of(edges, line.back());
    for (std::uint32_t bits = bits_of(last < 0.0F); bits != 0; bits &= bits - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
      const float share = first[lane] / (first[lane] - last[lane]);
      if (crossed.four != nullptr && share >= least) continue;
      least = share;
      crossed = {&edges, lane};
    }
  }
  if (crossed.four == nullptr) return line.size();
  const auto end = std::ranges::partition_point(line, [&](const ScanSample& sample) {
    return left_of(*crossed.four, crossed.lane, sample) >= 0.0F;
  });
  return static_cast<std::size_t>(end - line.begin());
}

void CarpetHull::measure(const RadialScan& scan, const ScanLines& lines) {
  collect(scan, lines);
  wrap();
  find_edges();
  ends_.clear();
  for (std::size_t i = 0; i < lines.radial().size(); ++i) {
    const auto line = lines.samples(lines.radial()[i]);
    const std::size_t carpet_end = scan.carpet_end(i);
    const std::size_t more = carpet_end < line.size() ? inside_count(line.subspan(carpet_end)) : 0;
    ends_.push_back(carpet_end + more);
  }
}

}  // namespace teamsight::vision
