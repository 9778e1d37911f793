// vision/carpet_hull.hpp: how far the carpet reaches in each direction, were nothing standing on
// it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/lanes.hpp"
#include "vision/radial_scan.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

/// Four edges of a hull: for each x times a place's x and y times its y and z add up to something
/// positive to the edge's left.
struct FourEdges {
  FourFloats x{};
  FourFloats y{};
  FourFloats z{};
};

/// A carpet has straight edges and no dents: what looks like a dent in the convex hull of the
/// carpet that is seen is hidden by something. Its buffers are its only state.
class CarpetHull {
 public:
  explicit CarpetHull(const ScanLines& lines);

  void measure(const RadialScan& scan, const ScanLines& lines);

  /// How many samples of each radial line lie inside the hull.
  [[nodiscard]] std::size_t end(std::size_t radial_line) const { return ends_[radial_line]; }

 private:
  void collect(const RadialScan& scan, const ScanLines& lines);
  void wrap();
  void find_edges();
  /// How many samples of a line from its start on are inside; a radial line is straight on the
  /// floor as well.
  [[nodiscard]] std::size_t inside_count(std::span<const ScanSample> line) const;

  std::vector<float> reach_;             // of each line; m
  std::vector<Eigen::Vector2f> points_;  // on the floor, in R; m
  std::vector<Eigen::Vector2f> hull_;    // counter-clockwise
  std::vector<FourEdges> edges_;         // of the hull
  std::vector<std::size_t> ends_;
};

}  // namespace teamsight::vision
