// vision/mirror/curvature.cpp: the circle arc between the isometric part and the ring.
#include "vision/mirror/curvature.hpp"

#include <cmath>

#include "geometry/expect.hpp"

namespace teamsight::mirror {

double outer_slope_angle(
    double t_B, double x_B, double height_B, double max_distance, double max_height) {
  TEAMSIGHT_EXPECT(max_distance > x_B);
  const double psi = std::atan2(max_distance - x_B, height_B - max_height);
  return 0.5 * (psi - std::atan(t_B));
}

Arc make_arc(const Node& start, double end_x, double end_angle) {
  TEAMSIGHT_EXPECT(end_x > start.x);
  const double start_angle = std::atan(start.slope);
  return {start, end_x, (std::sin(end_angle) - std::sin(start_angle)) / (end_x - start.x)};
}

Node at(const Arc& arc, double x) {
  // The sine of the slope angle is linear in x, and a chord's angle is the mean of its ends'
  // angles. Written so, a straight line is no special case.
  const double start_angle = std::atan(arc.start.slope);
  const double angle = std::asin(std::sin(start_angle) + arc.curvature * (x - arc.start.x));
  const double y = arc.start.y + (x - arc.start.x) * std::tan(0.5 * (start_angle + angle));
  return {x, y, std::tan(angle)};
}

std::vector<Node> sample(const Arc& arc, std::size_t intervals) {
  TEAMSIGHT_EXPECT(intervals >= 1);
  std::vector<Node> nodes;
  nodes.reserve(intervals + 1);
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(intervals);
    nodes.push_back(at(arc, arc.start.x + (arc.end_x - arc.start.x) * part));
  }
  return nodes;
}

}  // namespace teamsight::mirror
